package simgsm.center.smsc;

import java.time.Instant;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.event.EventLine;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;
import simgsm.sms.UserData;

/**
 * An accepted message, with all stored fields.
 *
 * <p>As a line: answer to {@code messages}.
 *
 * @param id unique, increasing in the order of acceptance
 * @param from the sender's number as authenticated by the network
 * @param submit the SUBMIT as received (TS 23.040, 9.2.2.2)
 * @param acceptedAt the service centre time stamp; see {@link TimeStamps} for equal messages
 * @param expiresAt end of the validity period
 * @param esme empty for a message from a mobile
 */
@EventLine("queued id= from= to= state=")
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

    /** The id known to an application: the last one of its submission. */
    public long submissionId() {
        return id + esme.map(origin -> origin.group().after()).orElse(0);
    }

    ShortMessage stampedAt(Instant stamp) {
        return new ShortMessage(id, from, to, submit, stamp, expiresAt, esme);
    }

    /** The originator address for the receiver. */
    public SmsAddress sender() {
        return esme.map(EsmeOrigin::source).orElseGet(() -> SmsAddress.of(from));
    }

    /** The text for a user. */
    public String text() {
        return TransferUnits.text(this);
    }

    /** The user data as submitted. */
    public UserData userData() {
        return TransferUnits.submitOf(this).userData();
    }
}
