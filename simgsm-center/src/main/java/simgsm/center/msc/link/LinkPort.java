package simgsm.center.msc.link;

import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;

/** The socket of a link. No method calls back into the exchange. */
public interface LinkPort extends MediaPort {
    /** Sends frames in the order of the calls; if the peer is too slow, old speech frames are dropped. */
    void send(IpaFrame frame);

    /**
     * Opens another socket for speech, for one channel of a tower.
     *
     * @param received receives each packet
     */
    default MediaPort newMedia(Consumer<byte[]> received) {
        return new MediaPort() {};
    }

    /** Closes the connection; no further event of this link follows. */
    void close(String reason);
}
