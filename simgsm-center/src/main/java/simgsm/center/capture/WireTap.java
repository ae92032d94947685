package simgsm.center.capture;

import simgsm.abis.IpaFrame;

/** Receives the frames of one connection. */
public interface WireTap {
    /** Used for connections that are not captured. */
    WireTap NONE = new WireTap() {
        @Override
        public void received(IpaFrame frame) {}

        @Override
        public void sent(byte[] wire) {}

        @Override
        public void datagram(boolean isFromPeer, int peerPort, int centerPort, byte[] rtp) {}

        @Override
        public void closed(boolean isByPeer) {}
    };

    void received(IpaFrame frame);

    /** @param wire a frame sent, as on the wire */
    void sent(byte[] wire);

    /** A datagram of speech has been sent or received, with these ports. */
    void datagram(boolean isFromPeer, int peerPort, int centerPort, byte[] rtp);

    /** Called once. */
    void closed(boolean isByPeer);
}
