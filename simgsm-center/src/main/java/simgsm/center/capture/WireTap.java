package simgsm.center.capture;

import simgsm.abis.IpaFrame;

/** Told of what passes on one connection. */
public interface WireTap {
    /** Where nobody listens. */
    WireTap NONE = new WireTap() {
        @Override
        public void received(IpaFrame frame) {}

        @Override
        public void sent(byte[] wire) {}

        @Override
        public void closed(boolean isByPeer) {}
    };

    void received(IpaFrame frame);

    /** @param wire a frame that has left, as it was on the wire */
    void sent(byte[] wire);

    /** Once is enough. */
    void closed(boolean isByPeer);
}
