package simgsm.ss;

import java.util.Optional;
import simgsm.air.Coded;

/** Errors of supplementary service operations (TS 24.080, 4.5; codes of TS 29.002, 17.5). */
public enum SsError implements Coded.Titled {
    UNKNOWN_SUBSCRIBER(1, "unknown subscriber"),
    ILLEGAL_SUBSCRIBER(9, "illegal subscriber"),
    BEARER_SERVICE_NOT_PROVISIONED(10, "bearer service not provisioned"),
    TELESERVICE_NOT_PROVISIONED(11, "teleservice not provisioned"),
    ILLEGAL_EQUIPMENT(12, "illegal equipment"),
    CALL_BARRED(13, "call barred"),
    ILLEGAL_SS_OPERATION(16, "illegal SS operation"),
    SS_ERROR_STATUS(17, "SS error status"),
    SS_NOT_AVAILABLE(18, "SS not available"),
    SS_SUBSCRIPTION_VIOLATION(19, "SS subscription violation"),
    SS_INCOMPATIBILITY(20, "SS incompatibility"),
    FACILITY_NOT_SUPPORTED(21, "facility not supported"),
    ABSENT_SUBSCRIBER(27, "absent subscriber"),
    SYSTEM_FAILURE(34, "system failure"),
    DATA_MISSING(35, "data missing"),
    UNEXPECTED_DATA_VALUE(36, "unexpected data value"),
    PASSWORD_REGISTRATION_FAILURE(37, "password registration failure"),
    NEGATIVE_PASSWORD_CHECK(38, "negative password check"),
    PASSWORD_ATTEMPTS_VIOLATION(43, "number of password attempts violation"),
    UNKNOWN_ALPHABET(71, "unknown alphabet"),
    USSD_BUSY(72, "USSD busy");

    private final Row row;

    SsError(int code, String title) {
        row = new Row(code, title);
    }

    @Override
    public Row row() {
        return row;
    }

    /** The error with this code; empty if unknown. */
    public static Optional<SsError> ofCode(int code) {
        return Coded.find(values(), code);
    }
}
