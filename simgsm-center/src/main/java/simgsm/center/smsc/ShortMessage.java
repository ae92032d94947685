package simgsm.center.smsc;

import java.time.Instant;
import simgsm.air.Msisdn;
import simgsm.air.OctetString;

/**
 * An accepted message, all that a store must keep of it.
 *
 * @param id given by the centre, unique and rising
 * @param from the number that the network vouches for
 * @param submit the SUBMIT as it came (TS 23.040, 9.2.2.2)
 * @param acceptedAt the service centre time stamp
 * @param expiresAt end of the validity period
 */
public record ShortMessage(long id, Msisdn from, Msisdn to, OctetString submit, Instant acceptedAt, Instant expiresAt) {
    /** What the message says; for data, its octets in hexadecimal. */
    public String text() {
        return TransferUnits.text(this);
    }
}
