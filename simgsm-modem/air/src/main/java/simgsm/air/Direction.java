package simgsm.air;

/** The direction of a message on the air interface; it determines the meaning of some octets. */
public enum Direction {
    /** From the mobile to the network. */
    UPLINK,
    /** From the network to the mobile. */
    DOWNLINK
}
