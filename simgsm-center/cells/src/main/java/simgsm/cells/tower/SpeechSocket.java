package simgsm.cells.tower;

import simgsm.abis.MgcpMessage.MediaAddress;

/** The UDP socket of one channel's speech. */
public interface SpeechSocket {
    /** Its local address, with an IPv4 host. */
    MediaAddress address();

    /**
     * Sends to this address and receives from it only.
     *
     * @return false if that is impossible
     */
    boolean connect(MediaAddress peer);

    void send(byte[] rtp);

    void close();
}
