package simgsm.abis;

import java.util.Optional;
import simgsm.abis.MgcpMessage.MediaAddress;

/** RTP over UDP beside a connection; by default there is none. */
public interface MediaPort {
    /** Opens a socket, in place of an older one. @return where it receives; empty if it cannot be opened */
    default Optional<MediaAddress> openMedia() {
        return Optional.empty();
    }

    /** Sends to this address and receives from it only. @return false if it is not on the host of the connection's peer */
    default boolean connectMedia(MediaAddress peer) {
        return false;
    }

    /** Sends one packet. @return false if no media is connected */
    default boolean sendMedia(byte[] rtp) {
        return false;
    }

    /** Closes the socket, if there is one. */
    default void closeMedia() {}
}
