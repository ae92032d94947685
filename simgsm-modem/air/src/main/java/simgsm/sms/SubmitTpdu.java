package simgsm.sms;

import java.util.Optional;
import simgsm.octets.Bounds;

/**
 * SMS-SUBMIT, from a mobile to the centre.
 *
 * @param rejectDuplicates TP-RD: refuse a message with reference, destination and sender of a waiting one
 * @param statusReportRequest TP-SRR
 * @param replyPath TP-RP
 * @param reference TP-MR, 0 to 255
 * @param protocolIdentifier TP-PID, 0 for plain messages
 * @param validity TP-VP; the centre's default if empty
 */
public record SubmitTpdu(
        boolean rejectDuplicates,
        boolean statusReportRequest,
        boolean replyPath,
        int reference,
        SmsAddress destination,
        int protocolIdentifier,
        Optional<ValidityPeriod> validity,
        UserData userData)
        implements Tpdu {
    public SubmitTpdu {
        Bounds.checkOctet("TP-MR", reference);
        Bounds.checkOctet("TP-PID", protocolIdentifier);
    }

    /** A message with a status report, valid for one day. */
    public static SubmitTpdu of(int reference, SmsAddress destination, UserData userData) {
        return new SubmitTpdu(
                false, true, false, reference, destination, 0, Optional.of(ValidityPeriod.Relative.ONE_DAY), userData);
    }
}
