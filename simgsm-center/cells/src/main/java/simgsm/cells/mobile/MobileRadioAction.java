package simgsm.cells.mobile;

/** Actions of {@link MobileRadioTable}. */
public enum MobileRadioAction {
    REQUEST_CHANNEL,
    END_ACCESS,
    ESTABLISH,
    BEGIN_ASSIGNMENT,
    COMPLETE_ASSIGNMENT,
    FAIL_ASSIGNMENT,
    BEGIN_HANDOVER,
    COMPLETE_HANDOVER,
    FAIL_HANDOVER,
    SEND_HELD,
    LEAVE_CHANNEL,
    FORSAKE_CHANNEL,
    RELEASE_TERMINAL,
    FORGET
}
