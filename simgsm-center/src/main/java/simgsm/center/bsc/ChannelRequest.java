package simgsm.center.bsc;

import simgsm.abis.rsl.RslElement;
import simgsm.abis.rsl.RslPdu;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/**
 * A mobile's request for a channel, as the tower has received it.
 *
 * @param reference the CHANNEL REQUEST and its frame number, 3 octets, which come back in the answer
 * @param accessDelay the timing advance that the mobile needs, in bits
 */
record ChannelRequest(OctetString reference, int accessDelay) {
    static ChannelRequest of(RslPdu message) throws ProtocolViolation {
        return new ChannelRequest(
                message.value(RslElement.REQUEST_REFERENCE), message.octet(RslElement.ACCESS_DELAY) & 0x3f);
    }
}
