package simgsm.sms;

import java.util.Optional;

/**
 * SMS-SUBMIT, from a mobile to the centre.
 *
 * @param rejectDuplicates TP-RD: refuse what has the same reference, destination and sender as a message still held
 * @param statusReportRequest TP-SRR
 * @param replyPath TP-RP
 * @param reference TP-MR, 0 to 255
 * @param protocolIdentifier TP-PID, 0 for plain messages
 * @param validity how long to try; without it the centre decides
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
        TpduCodec.checkOctet("TP-MR", reference);
        TpduCodec.checkOctet("TP-PID", protocolIdentifier);
    }

    /** A plain message with a report of its delivery, tried for a day. */
    public static SubmitTpdu of(int reference, SmsAddress destination, UserData userData) {
        return new SubmitTpdu(
                false, true, false, reference, destination, 0, Optional.of(ValidityPeriod.Relative.ONE_DAY), userData);
    }
}
