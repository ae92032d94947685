package simgsm.air;

/** The direction of a message on the air interface; some octets have a different meaning in each. */
public enum Direction {
    /** From the mobile to the network. */
    UPLINK,
    /** From the network to the mobile. */
    DOWNLINK
}
