package simgsm.air;

/** Causes of the end of a call or the refusal of a call-control message (TS 24.008, 10.5.4.11 and annex H). */
public enum Cause implements Coded.Titled {
    UNASSIGNED_NUMBER(1, "unassigned number"),
    NO_ROUTE_TO_DESTINATION(3, "no route to destination"),
    CHANNEL_UNACCEPTABLE(6, "channel unacceptable"),
    OPERATOR_DETERMINED_BARRING(8, "operator determined barring"),
    NORMAL_CALL_CLEARING(16, "normal call clearing"),
    USER_BUSY(17, "user busy"),
    NO_USER_RESPONDING(18, "no user responding"),
    USER_ALERTING_NO_ANSWER(19, "user alerting, no answer"),
    CALL_REJECTED(21, "call rejected"),
    NUMBER_CHANGED(22, "number changed"),
    CALL_REJECTED_BY_FEATURE_AT_DESTINATION(24, "call rejected due to feature at the destination"),
    PRE_EMPTION(25, "pre-emption"),
    NON_SELECTED_USER_CLEARING(26, "non-selected user clearing"),
    DESTINATION_OUT_OF_ORDER(27, "destination out of order"),
    INVALID_NUMBER_FORMAT(28, "invalid number format"),
    FACILITY_REJECTED(29, "facility rejected"),
    RESPONSE_TO_STATUS_ENQUIRY(30, "response to STATUS ENQUIRY"),
    NORMAL_UNSPECIFIED(31, "normal, unspecified"),
    NO_CIRCUIT_AVAILABLE(34, "no circuit/channel available"),
    NETWORK_OUT_OF_ORDER(38, "network out of order"),
    TEMPORARY_FAILURE(41, "temporary failure"),
    SWITCHING_EQUIPMENT_CONGESTION(42, "switching equipment congestion"),
    ACCESS_INFORMATION_DISCARDED(43, "access information discarded"),
    REQUESTED_CIRCUIT_NOT_AVAILABLE(44, "requested circuit/channel not available"),
    RESOURCES_UNAVAILABLE(47, "resources unavailable, unspecified"),
    QUALITY_OF_SERVICE_UNAVAILABLE(49, "quality of service unavailable"),
    REQUESTED_FACILITY_NOT_SUBSCRIBED(50, "requested facility not subscribed"),
    INCOMING_CALLS_BARRED_WITHIN_CUG(55, "incoming calls barred within the CUG"),
    BEARER_CAPABILITY_NOT_AUTHORIZED(57, "bearer capability not authorized"),
    BEARER_CAPABILITY_NOT_PRESENTLY_AVAILABLE(58, "bearer capability not presently available"),
    SERVICE_NOT_AVAILABLE(63, "service or option not available, unspecified"),
    BEARER_SERVICE_NOT_IMPLEMENTED(65, "bearer service not implemented"),
    ACM_AT_MAXIMUM(68, "ACM equal to or greater than ACMmax"),
    REQUESTED_FACILITY_NOT_IMPLEMENTED(69, "requested facility not implemented"),
    ONLY_RESTRICTED_BEARER_AVAILABLE(70, "only restricted digital information bearer capability is available"),
    SERVICE_NOT_IMPLEMENTED(79, "service or option not implemented, unspecified"),
    INVALID_TRANSACTION_IDENTIFIER(81, "invalid transaction identifier value"),
    USER_NOT_MEMBER_OF_CUG(87, "user not member of CUG"),
    INCOMPATIBLE_DESTINATION(88, "incompatible destination"),
    INVALID_TRANSIT_NETWORK_SELECTION(91, "invalid transit network selection"),
    SEMANTICALLY_INCORRECT_MESSAGE(95, "semantically incorrect message"),
    INVALID_MANDATORY_INFORMATION(96, "invalid mandatory information"),
    MESSAGE_TYPE_NON_EXISTENT(97, "message type non-existent or not implemented"),
    MESSAGE_NOT_COMPATIBLE_WITH_STATE(98, "message type not compatible with protocol state"),
    INFORMATION_ELEMENT_NON_EXISTENT(99, "information element non-existent or not implemented"),
    CONDITIONAL_ELEMENT_ERROR(100, "conditional IE error"),
    MESSAGE_NOT_COMPATIBLE_WITH_CALL_STATE(101, "message not compatible with protocol state"),
    RECOVERY_ON_TIMER_EXPIRY(102, "recovery on timer expiry"),
    PROTOCOL_ERROR(111, "protocol error, unspecified"),
    INTERWORKING(127, "interworking, unspecified");

    private final Row row;

    Cause(int code, String title) {
        row = new Row(code, title);
    }

    @Override
    public Row row() {
        return row;
    }

    /**
     * The cause with this code, 0 to 127; for an unlisted code the "unspecified" cause of its class: 31 normal, 47
     * resources, 63 not available, 79 not implemented, 95 invalid, 111 protocol, 127 interworking (10.5.4.11, notes
     * to table 10.5.123).
     */
    public static Cause ofCode(int code) {
        int lastOfClass = code < 32 ? 31 : code | 0x0f;
        return Coded.find(values(), code)
                .orElseGet(() -> Coded.find(values(), lastOfClass).orElseThrow());
    }
}
