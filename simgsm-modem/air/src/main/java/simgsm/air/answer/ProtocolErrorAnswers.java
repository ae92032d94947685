package simgsm.air.answer;

import java.util.List;
import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.CauseLocation;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Message;
import simgsm.air.Layer3Type;
import simgsm.air.MobilityManagement;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.SupplementaryService;
import simgsm.air.TransactionIdentifier;

/**
 * The answers to a received layer-3 message that breaks its standard (TS 24.008, 8; TS 24.011, 9; TS 24.010, 4.2), in the opposite
 * direction.
 */
public final class ProtocolErrorAnswers {
    private ProtocolErrorAnswers() {}

    /**
     * The messages to send, in order. Empty for a message without a readable header, and for one that itself reports
     * an error, which would cause endless answers.
     *
     * @param callState state of the transaction's call at this side as coded in TS 24.008, 10.5.4.6; 0 if there is no
     *     call
     */
    public static List<Layer3Message> to(ProtocolViolation violation, int callState) {
        return violation
                .header()
                .map(header -> answers(header, violation.statusCause(), callState))
                .orElse(List.of());
    }

    private static List<Layer3Message> answers(Layer3Header header, Cause cause, int callState) {
        Optional<Layer3Type> type = header.type();
        if (type.isPresent() && reportsAnError(type.get())) {
            return List.of();
        }
        return switch (header.discriminator()) {
            case Layer3Header.CALL_CONTROL -> List.of(callControl(header, type, cause, callState));
            case Layer3Header.MOBILITY_MANAGEMENT ->
                List.of(mobilityManagement(type, RejectCause.ofCode(cause.code(), header.direction())));
            case Layer3Header.RADIO_RESOURCE -> List.of(new RadioResource.RrStatus(cause.code()));
            case Layer3Header.SUPPLEMENTARY_SERVICES ->
                List.of(new SupplementaryService.SsReleaseComplete(
                        header.transaction().orElseThrow().answered(), cause));
            default -> shortMessage(header, cause);
        };
    }

    private static boolean reportsAnError(Layer3Type type) {
        return type == Layer3Type.STATUS
                || type == Layer3Type.MM_STATUS
                || type == Layer3Type.RR_STATUS
                || type == Layer3Type.CP_ERROR
                || type == Layer3Type.SS_RELEASE_COMPLETE;
    }

    /** A refused SETUP creates no call, so RELEASE COMPLETE is the answer (TS 24.008, 8.5.1). */
    private static Layer3Message callControl(
            Layer3Header header, Optional<Layer3Type> type, Cause cause, int callState) {
        TransactionIdentifier transaction = header.transaction().orElseThrow().answered();
        if (type.equals(Optional.of(Layer3Type.SETUP))) {
            return new CallControl.ReleaseComplete(
                    transaction, Optional.of(cause), Optional.of(CauseLocation.of(header.direction(), true)));
        }
        return new CallControl.Status(transaction, cause, callState);
    }

    /** Two requests have their own reject messages (TS 24.008, 4.4.4.9 and 4.5.1.7). */
    private static Layer3Message mobilityManagement(Optional<Layer3Type> type, RejectCause cause) {
        if (type.equals(Optional.of(Layer3Type.LOCATION_UPDATING_REQUEST))) {
            return new MobilityManagement.LocationUpdatingReject(cause);
        }
        if (type.equals(Optional.of(Layer3Type.CM_SERVICE_REQUEST))) {
            return new MobilityManagement.CmServiceReject(cause);
        }
        return new MobilityManagement.MmStatus(cause);
    }

    /** A valid CP-DATA with a broken RP message is acknowledged, and the RP layer refuses. */
    private static List<Layer3Message> shortMessage(Layer3Header header, Cause cause) {
        TransactionIdentifier transaction = header.transaction().orElseThrow().answered();
        return header.relayReference()
                .map(reference -> List.<Layer3Message>of(
                        new ShortMessageControl.CpAck(transaction),
                        new ShortMessageControl.CpData(
                                transaction, new RelayMessage.RpError(reference, RpCause.ofCode(cause.code())))))
                .orElseGet(() -> List.of(new ShortMessageControl.CpError(transaction, cause.code())));
    }
}
