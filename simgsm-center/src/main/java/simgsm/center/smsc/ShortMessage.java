package simgsm.center.smsc;

import java.time.Instant;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;
import simgsm.sms.UserData;

/**
 * An accepted message, all that a store must keep of it.
 *
 * @param id given by the centre, unique and rising
 * @param from the number that the network vouches for
 * @param submit the SUBMIT as it came (TS 23.040, 9.2.2.2)
 * @param acceptedAt the service centre time stamp; a few seconds late where many messages alike came at once
 * @param expiresAt end of the validity period
 * @param esme empty for a message from a mobile
 */
public record ShortMessage(
        long id,
        Msisdn from,
        Msisdn to,
        OctetString submit,
        Instant acceptedAt,
        Instant expiresAt,
        Optional<EsmeOrigin> esme) {
    /** A mobile's message. */
    public ShortMessage(long id, Msisdn from, Msisdn to, OctetString submit, Instant acceptedAt, Instant expiresAt) {
        this(id, from, to, submit, acceptedAt, expiresAt, Optional.empty());
    }

    ShortMessage stampedAt(Instant stamp) {
        return new ShortMessage(id, from, to, submit, stamp, expiresAt, esme);
    }

    /** What the receiver is shown as the sender. */
    public SmsAddress sender() {
        return esme.map(EsmeOrigin::source).orElseGet(() -> SmsAddress.of(from));
    }

    /** What the message says; for data, its octets in hexadecimal. */
    public String text() {
        return TransferUnits.text(this);
    }

    /** The user part as it was submitted. */
    public UserData userData() {
        return TransferUnits.submitOf(this).userData();
    }
}
