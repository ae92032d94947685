package simgsm.center.msc.link;

import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;

/** The socket of a link. No method calls back into the exchange. */
public interface LinkPort extends MediaPort {
    /** Sends frames in the order of the calls; if the peer does not keep up, old speech frames are dropped. */
    void send(IpaFrame frame);

    /** Closes the connection; the exchange expects no further event of this link. */
    void close(String reason);
}
