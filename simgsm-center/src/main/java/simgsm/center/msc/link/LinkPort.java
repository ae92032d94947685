package simgsm.center.msc.link;

import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;

/** The socket of a link. No method calls back into the exchange. */
public interface LinkPort extends MediaPort {
    /** Sends frames in the order of the calls; if the peer does not keep up, old speech frames are dropped. */
    void send(IpaFrame frame);

    /** Another socket for speech beside the connection, for one channel of a tower. @param received is given each packet */
    default MediaPort newMedia(Consumer<byte[]> received) {
        return new MediaPort() {};
    }

    /** Closes the connection; the exchange expects no further event of this link. */
    void close(String reason);
}
