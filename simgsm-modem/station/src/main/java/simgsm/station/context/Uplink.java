package simgsm.station.context;

import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;

/** One established connection from a station to the centre. */
public interface Uplink extends MediaPort {
    /** No connection: frames are dropped. */
    Uplink DISCONNECTED = new Uplink() {
        @Override
        public void send(IpaFrame frame) {}

        @Override
        public void drop() {}
    };

    void send(IpaFrame frame);

    /** Ends the connection; the station's linkDown is called later, not from within. */
    void drop();
}
