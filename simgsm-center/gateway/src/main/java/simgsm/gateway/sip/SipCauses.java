package simgsm.gateway.sip;

import java.util.Map;
import simgsm.air.Cause;
import simgsm.air.RpCause;

/** Causes of the network as statuses of SIP and back (RFC 3398, 7.2.4.1 and 8.2.6.1). */
final class SipCauses {
    private static final Map<Integer, String> REASONS = Map.ofEntries(
            Map.entry(403, "Forbidden"),
            Map.entry(404, "Not Found"),
            Map.entry(408, "Request Timeout"),
            Map.entry(410, "Gone"),
            Map.entry(480, "Temporarily Unavailable"),
            Map.entry(484, "Address Incomplete"),
            Map.entry(486, "Busy Here"),
            Map.entry(488, "Not Acceptable Here"),
            Map.entry(500, "Server Internal Error"),
            Map.entry(501, "Not Implemented"),
            Map.entry(503, "Service Unavailable"),
            Map.entry(504, "Server Time-out"),
            Map.entry(603, "Decline"));

    private SipCauses() {}

    /** The final response to an INVITE whose call has ended before the answer. */
    static int status(Cause cause) {
        return switch (cause) {
            case UNASSIGNED_NUMBER, NO_ROUTE_TO_DESTINATION, NON_SELECTED_USER_CLEARING -> 404;
            case USER_BUSY -> 486;
            case NO_USER_RESPONDING -> 408;
            case NORMAL_CALL_CLEARING, USER_ALERTING_NO_ANSWER, DESTINATION_OUT_OF_ORDER, NORMAL_UNSPECIFIED -> 480;
            case CALL_REJECTED -> 603;
            case NUMBER_CHANGED -> 410;
            case INVALID_NUMBER_FORMAT -> 484;
            case FACILITY_REJECTED, SERVICE_NOT_IMPLEMENTED -> 501;
            case OPERATOR_DETERMINED_BARRING,
                    INCOMING_CALLS_BARRED_WITHIN_CUG,
                    BEARER_CAPABILITY_NOT_AUTHORIZED,
                    USER_NOT_MEMBER_OF_CUG -> 403;
            case BEARER_SERVICE_NOT_IMPLEMENTED, ONLY_RESTRICTED_BEARER_AVAILABLE -> 488;
            case RECOVERY_ON_TIMER_EXPIRY -> 504;
            case PROTOCOL_ERROR, INTERWORKING -> 500;
            default -> 503;
        };
    }

    /** The final response to a MESSAGE that the network has refused. */
    static int status(RpCause cause) {
        return switch (cause) {
            case UNASSIGNED_NUMBER, UNIDENTIFIED_SUBSCRIBER, UNKNOWN_SUBSCRIBER -> 404;
            case OPERATOR_DETERMINED_BARRING, CALL_BARRED, SHORT_MESSAGE_TRANSFER_REJECTED -> 403;
            default -> 503;
        };
    }

    static String reason(int status) {
        return REASONS.get(status);
    }

    /** The cause for the network when a phone refuses a call. */
    static Cause cause(int status) {
        return switch (status) {
            case 401, 402, 403, 407, 603 -> Cause.CALL_REJECTED;
            case 404, 485, 604 -> Cause.UNASSIGNED_NUMBER;
            case 405 -> Cause.SERVICE_NOT_AVAILABLE;
            case 406, 415, 501 -> Cause.SERVICE_NOT_IMPLEMENTED;
            case 408, 504 -> Cause.RECOVERY_ON_TIMER_EXPIRY;
            case 410 -> Cause.NUMBER_CHANGED;
            case 480 -> Cause.NO_USER_RESPONDING;
            case 484 -> Cause.INVALID_NUMBER_FORMAT;
            case 486, 600 -> Cause.USER_BUSY;
            case 488 -> Cause.BEARER_SERVICE_NOT_IMPLEMENTED;
            case 502 -> Cause.NETWORK_OUT_OF_ORDER;
            default -> Cause.TEMPORARY_FAILURE;
        };
    }
}
