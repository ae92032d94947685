package simgsm.smpp;

/** Values of command_status (5.1.3) that the centre sends or interprets. */
public final class SmppStatus {
    public static final int OK = 0x00;
    /** The length does not match the content. */
    public static final int INVALID_MESSAGE_LENGTH = 0x01;

    public static final int INVALID_COMMAND_LENGTH = 0x02;
    public static final int INVALID_COMMAND_ID = 0x03;
    /** The command is not permitted in the session's state. */
    public static final int INVALID_BIND_STATUS = 0x04;

    public static final int ALREADY_BOUND = 0x05;
    public static final int INVALID_PRIORITY = 0x06;
    public static final int INVALID_REGISTERED_DELIVERY = 0x07;
    public static final int SYSTEM_ERROR = 0x08;
    public static final int INVALID_SOURCE = 0x0a;
    public static final int INVALID_DESTINATION = 0x0b;
    public static final int INVALID_MESSAGE_ID = 0x0c;
    public static final int BIND_FAILED = 0x0d;
    public static final int INVALID_PASSWORD = 0x0e;
    public static final int INVALID_SYSTEM_ID = 0x0f;
    public static final int CANCEL_FAILED = 0x11;
    public static final int REPLACE_FAILED = 0x13;
    public static final int QUEUE_FULL = 0x14;
    public static final int INVALID_SERVICE_TYPE = 0x15;
    public static final int INVALID_NUMBER_OF_DESTINATIONS = 0x33;
    public static final int INVALID_DISTRIBUTION_LIST = 0x34;
    public static final int INVALID_DESTINATION_FLAG = 0x40;
    public static final int INVALID_ESM_CLASS = 0x43;
    public static final int SUBMIT_FAILED = 0x45;
    public static final int INVALID_SOURCE_TYPE = 0x48;
    public static final int INVALID_SOURCE_PLAN = 0x49;
    public static final int INVALID_DESTINATION_TYPE = 0x50;
    public static final int INVALID_DESTINATION_PLAN = 0x51;
    public static final int INVALID_SYSTEM_TYPE = 0x53;
    public static final int INVALID_REPLACE_FLAG = 0x54;
    public static final int THROTTLED = 0x58;
    public static final int INVALID_SCHEDULE = 0x61;
    public static final int INVALID_VALIDITY = 0x62;
    public static final int INVALID_DEFAULT_MESSAGE = 0x63;
    /** ESME receiver temporary application error. */
    public static final int TEMPORARY_APPLICATION_ERROR = 0x64;

    /** ESME receiver permanent application error. */
    public static final int PERMANENT_APPLICATION_ERROR = 0x65;

    public static final int QUERY_FAILED = 0x67;
    public static final int INVALID_OPTIONAL_PART = 0xc0;
    public static final int OPTIONAL_PARAMETER_NOT_ALLOWED = 0xc1;
    public static final int INVALID_PARAMETER_LENGTH = 0xc2;
    public static final int INVALID_PARAMETER_VALUE = 0xc4;
    /** Defined by SMPP 5.0, 4.7.6; SMPP 3.4 has no status for data_coding. */
    public static final int INVALID_DATA_CODING = 0x104;

    private SmppStatus() {}

    /** True if the same message may be accepted later. */
    public static boolean mayPass(int status) {
        return isBusy(status) || status == SYSTEM_ERROR || status == TEMPORARY_APPLICATION_ERROR;
    }

    /** True if it may be accepted within seconds. */
    public static boolean isBusy(int status) {
        return status == THROTTLED || status == QUEUE_FULL;
    }
}
