package simgsm.abis;

import simgsm.air.Cause;
import simgsm.air.ProtocolViolation;

/** RSL message types between a base station and its controller (TS 48.058, 9.2), and those of ip.access for speech. */
public enum RslType {
    DATA_REQUEST(0x02, 0x01, "Data Request"),
    DATA_INDICATION(0x02, 0x02, "Data Indication"),
    ERROR_INDICATION(0x02, 0x03, "Error Indication"),
    ESTABLISH_REQUEST(0x02, 0x04, "Establish Request"),
    ESTABLISH_CONFIRM(0x02, 0x05, "Establish Confirm"),
    ESTABLISH_INDICATION(0x02, 0x06, "Establish Indication"),
    RELEASE_REQUEST(0x02, 0x07, "Release Request"),
    RELEASE_CONFIRM(0x02, 0x08, "Release Confirm"),
    RELEASE_INDICATION(0x02, 0x09, "Release Indication"),
    UNIT_DATA_REQUEST(0x02, 0x0a, "Unit Data Request"),
    UNIT_DATA_INDICATION(0x02, 0x0b, "Unit Data Indication"),

    BCCH_INFORMATION(0x0c, 0x11, "BCCH Information"),
    CCCH_LOAD_INDICATION(0x0c, 0x12, "CCCH Load Indication"),
    CHANNEL_REQUIRED(0x0c, 0x13, "Channel Required"),
    DELETE_INDICATION(0x0c, 0x14, "Delete Indication"),
    PAGING_COMMAND(0x0c, 0x15, "Paging Command"),
    IMMEDIATE_ASSIGN_COMMAND(0x0c, 0x16, "Immediate Assign Command"),
    SMS_BROADCAST_REQUEST(0x0c, 0x17, "SMS Broadcast Request"),
    SMS_BROADCAST_COMMAND(0x0c, 0x1d, "SMS Broadcast Command"),
    CBCH_LOAD_INDICATION(0x0c, 0x1e, "CBCH Load Indication"),

    RF_RESOURCE_INDICATION(0x10, 0x19, "RF Resource Indication"),
    SACCH_FILLING(0x10, 0x1a, "SACCH Filling"),
    OVERLOAD(0x10, 0x1b, "Overload"),
    ERROR_REPORT(0x10, 0x1c, "Error Report"),
    /** Type of ip.access; its elements are not read. */
    MEASUREMENT_PREPROCESSING_DEFAULTS(0x10, 0x60, "ip.access Measurement Preprocessing Defaults"),

    CHANNEL_ACTIVATION(0x08, 0x21, "Channel Activation"),
    CHANNEL_ACTIVATION_ACKNOWLEDGE(0x08, 0x22, "Channel Activation Acknowledge"),
    CHANNEL_ACTIVATION_NEGATIVE_ACKNOWLEDGE(0x08, 0x23, "Channel Activation Negative Acknowledge"),
    CONNECTION_FAILURE(0x08, 0x24, "Connection Failure Indication"),
    DEACTIVATE_SACCH(0x08, 0x25, "Deactivate SACCH"),
    ENCRYPTION_COMMAND(0x08, 0x26, "Encryption Command"),
    HANDOVER_DETECTION(0x08, 0x27, "Handover Detection"),
    MEASUREMENT_RESULT(0x08, 0x28, "Measurement Result"),
    MODE_MODIFY_REQUEST(0x08, 0x29, "Mode Modify Request"),
    MODE_MODIFY_ACKNOWLEDGE(0x08, 0x2a, "Mode Modify Acknowledge"),
    MODE_MODIFY_NEGATIVE_ACKNOWLEDGE(0x08, 0x2b, "Mode Modify Negative Acknowledge"),
    RF_CHANNEL_RELEASE(0x08, 0x2e, "RF Channel Release"),
    MS_POWER_CONTROL(0x08, 0x2f, "MS Power Control"),
    BS_POWER_CONTROL(0x08, 0x30, "BS Power Control"),
    RF_CHANNEL_RELEASE_ACKNOWLEDGE(0x08, 0x33, "RF Channel Release Acknowledge"),
    SACCH_INFORMATION_MODIFY(0x08, 0x34, "SACCH Information Modify"),

    CREATE_CONNECTION(0x7e, 0x70, "ip.access CRCX"),
    CREATE_CONNECTION_ACKNOWLEDGE(0x7e, 0x71, "ip.access CRCX Acknowledge"),
    CREATE_CONNECTION_NEGATIVE_ACKNOWLEDGE(0x7e, 0x72, "ip.access CRCX Negative Acknowledge"),
    MODIFY_CONNECTION(0x7e, 0x73, "ip.access MDCX"),
    MODIFY_CONNECTION_ACKNOWLEDGE(0x7e, 0x74, "ip.access MDCX Acknowledge"),
    MODIFY_CONNECTION_NEGATIVE_ACKNOWLEDGE(0x7e, 0x75, "ip.access MDCX Negative Acknowledge"),
    /** The base station has deleted the connection by itself, as with the channel. */
    DELETE_CONNECTION_INDICATION(0x7e, 0x76, "ip.access DLCX Indication"),
    DELETE_CONNECTION(0x7e, 0x77, "ip.access DLCX"),
    DELETE_CONNECTION_ACKNOWLEDGE(0x7e, 0x78, "ip.access DLCX Acknowledge"),
    DELETE_CONNECTION_NEGATIVE_ACKNOWLEDGE(0x7e, 0x79, "ip.access DLCX Negative Acknowledge");

    private static final RslType[] BY_CODE = new RslType[256];

    static {
        for (RslType type : values()) {
            BY_CODE[type.code] = type;
        }
    }

    /** The lowest bit of the discriminator marks a message as transparent to the base station. */
    private static final int DISCRIMINATOR_MASK = 0xfe;

    private final int discriminator;
    private final int code;
    private final String title;

    RslType(int discriminator, int code, String title) {
        this.discriminator = discriminator;
        this.code = code;
        this.title = title;
    }

    /** The discriminator as sent: layer 3 is marked as transparent (TS 48.058, 9.1). */
    int discriminator() {
        return switch (this) {
            case DATA_REQUEST, DATA_INDICATION, UNIT_DATA_REQUEST, UNIT_DATA_INDICATION -> discriminator | 1;
            default -> discriminator;
        };
    }

    /** The message type octet. */
    public int code() {
        return code;
    }

    /** The message's name in the standard. */
    public String title() {
        return title;
    }

    /** The type of a message. @throws ProtocolViolation for an unknown one */
    static RslType of(int discriminator, int code) throws ProtocolViolation {
        RslType type = BY_CODE[code];
        if (type == null || type.discriminator != (discriminator & DISCRIMINATOR_MASK)) {
            throw new ProtocolViolation(
                    Cause.MESSAGE_TYPE_NON_EXISTENT,
                    String.format("RSL message type 0x%02x of discriminator 0x%02x", code, discriminator));
        }
        return type;
    }
}
