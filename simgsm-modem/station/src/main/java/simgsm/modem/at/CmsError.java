package simgsm.modem.at;

/** Errors of message commands (TS 27.005, 3.2.5); codes below 128 are the causes of TS 24.011. */
public final class CmsError {
    public static final int OPERATION_NOT_ALLOWED = 302;
    public static final int OPERATION_NOT_SUPPORTED = 303;
    public static final int INVALID_PDU_PARAMETER = 304;
    public static final int INVALID_TEXT_PARAMETER = 305;
    public static final int INVALID_MEMORY_INDEX = 321;
    public static final int MEMORY_FULL = 322;
    public static final int NO_NETWORK_SERVICE = 331;
    public static final int NO_ACKNOWLEDGEMENT_EXPECTED = 340;

    private CmsError() {}
}
