package simgsm.center.bsc;

import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.air.ProtocolViolation;
import simgsm.rr.RequestReference;

/**
 * A mobile's request for a channel, as received by the tower.
 *
 * @param reference repeated in the answer
 * @param accessDelay the timing advance of the mobile, in bits
 */
record ChannelRequest(RequestReference reference, int accessDelay) {
    static ChannelRequest of(RslPdu message) throws ProtocolViolation {
        return new ChannelRequest(
                RequestReference.of(message.value(RslElement.REQUEST_REFERENCE)),
                message.octet(RslElement.ACCESS_DELAY) & 0x3f);
    }
}
