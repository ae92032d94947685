package simgsm.cells.mobile;

import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.octets.OctetString;

/** The cause in the upper bits of a CHANNEL REQUEST (TS 44.018, table 9.1.8.1, with NECI 1). */
final class EstablishmentCause {
    private static final int LOCATION_UPDATING = 0x00;
    private static final int SHORT_MESSAGE = 0x10;
    private static final int ANSWER_TO_PAGING = 0x80;
    private static final int EMERGENCY_CALL = 0xa0;
    private static final int ORIGINATING_CALL = 0xe0;
    private static final int FIVE_RANDOM_BITS = 32;
    private static final int FOUR_RANDOM_BITS = 16;

    private EstablishmentCause() {}

    static int of(OctetString firstMessage) {
        try {
            Layer3Message message = Layer3Codec.decode(firstMessage.toArray(), Direction.UPLINK);
            if (message instanceof PagingResponse) {
                return ANSWER_TO_PAGING;
            }
            if (message instanceof CmServiceRequest request) {
                return request.service() == ServiceType.MOBILE_ORIGINATED_CALL
                        ? ORIGINATING_CALL
                        : request.service() == ServiceType.EMERGENCY_CALL ? EMERGENCY_CALL : SHORT_MESSAGE;
            }
        } catch (ProtocolViolation unknown) {
            // other messages, such as detach, use location updating
        }
        return LOCATION_UPDATING;
    }

    /** True for a registration, and for an emergency call, which may be a mobile's first message. */
    static boolean waitsForCell(OctetString firstMessage) {
        int cause = of(firstMessage);
        return cause == LOCATION_UPDATING || cause == EMERGENCY_CALL;
    }

    /** The number of values of the lower bits. */
    static int randomValues(int cause) {
        return cause == LOCATION_UPDATING || cause == SHORT_MESSAGE ? FOUR_RANDOM_BITS : FIVE_RANDOM_BITS;
    }
}
