package simgsm.cells.tower;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;

/** The socket of a tower's link to its controller. */
public interface TowerPort {
    void send(IpaFrame frame);

    /**
     * Opens a UDP socket for the speech of one channel.
     *
     * @param received receives each RTP packet; empty if it cannot be opened
     */
    Optional<SpeechSocket> openSpeech(Consumer<byte[]> received);

    /** Ends the connection, which is then made again. */
    void drop(String reason);
}
