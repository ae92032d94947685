package simgsm.air;

/** Which way a message crosses the air; some octets mean different things each way. */
public enum Direction {
    /** From the mobile to the network. */
    UPLINK,
    /** From the network to the mobile. */
    DOWNLINK
}
