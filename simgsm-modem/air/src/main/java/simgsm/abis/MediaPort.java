package simgsm.abis;

import java.util.Optional;
import simgsm.abis.MgcpMessage.MediaAddress;

/** RTP over UDP in addition to a connection; unsupported by default. */
public interface MediaPort {
    /** Opens a socket and closes an older one. @return its address; empty if it cannot be opened */
    default Optional<MediaAddress> openMedia() {
        return Optional.empty();
    }

    /** Sends to this address and receives from it only. @return false if it is not on the peer's host */
    default boolean connectMedia(MediaAddress peer) {
        return false;
    }

    /** Sends one packet. @return false if no media is connected */
    default boolean sendMedia(byte[] rtp) {
        return false;
    }

    /** Closes the socket, if any. */
    default void closeMedia() {}
}
