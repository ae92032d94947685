package simgsm.cells.tower;

import simgsm.abis.MgcpMessage.MediaAddress;

/** The UDP socket of one channel's speech. */
public interface SpeechSocket {
    /** Where it receives; the host is an IPv4 address. */
    MediaAddress address();

    /** Sends to this address and receives from it only. @return false if that is not possible */
    boolean connect(MediaAddress peer);

    void send(byte[] rtp);

    void close();
}
