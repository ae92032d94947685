package simgsm.cells.mobile;

import simgsm.abis.IpaFrame;

/** The socket of a terminal. */
public interface MobilePort {
    void send(IpaFrame frame);

    void close(String reason);
}
