package simgsm.ss;

import java.util.Optional;
import simgsm.air.Coded;

/** Operations of supplementary services (TS 24.080, 4.5; codes of TS 29.002, 17.5). */
public enum SsOperation implements Coded.Titled {
    REGISTER_SS(10, "registerSS"),
    ERASE_SS(11, "eraseSS"),
    ACTIVATE_SS(12, "activateSS"),
    DEACTIVATE_SS(13, "deactivateSS"),
    INTERROGATE_SS(14, "interrogateSS"),
    NOTIFY_SS(16, "notifySS"),
    REGISTER_PASSWORD(17, "registerPassword"),
    GET_PASSWORD(18, "getPassword"),
    /** USSD of phase 1. */
    PROCESS_UNSTRUCTURED_SS_DATA(19, "processUnstructuredSS-Data"),
    FORWARD_CHECK_SS_INDICATION(38, "forwardCheckSS-Indication"),
    /** The mobile begins USSD. */
    PROCESS_UNSTRUCTURED_SS_REQUEST(59, "processUnstructuredSS-Request"),
    /** The network asks the user and expects an answer. */
    UNSTRUCTURED_SS_REQUEST(60, "unstructuredSS-Request"),
    /** The network shows a text. */
    UNSTRUCTURED_SS_NOTIFY(61, "unstructuredSS-Notify"),
    ERASE_CC_ENTRY(76, "eraseCC-Entry"),
    REGISTER_CC_ENTRY(77, "registerCC-Entry");

    private final Row row;

    SsOperation(int code, String title) {
        row = new Row(code, title);
    }

    @Override
    public Row row() {
        return row;
    }

    /** The operation with this code; empty if unknown. */
    public static Optional<SsOperation> ofCode(int code) {
        return Coded.find(values(), code);
    }
}
