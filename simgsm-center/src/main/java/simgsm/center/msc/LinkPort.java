package simgsm.center.msc;

import simgsm.abis.IpaFrame;

/** What the exchange can do to one terminal's connection. Neither method calls back into the exchange. */
public interface LinkPort {
    /** Frames leave in the order of the calls; when the peer does not keep up, old speech frames are dropped. */
    void send(IpaFrame frame);

    /** Ends the connection. The exchange has forgotten the link already and does not want to hear of it again. */
    void close(String reason);
}
