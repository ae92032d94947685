package simgsm.sms;

import simgsm.air.Cause;
import simgsm.air.ProtocolViolation;

/** What the short message layer refuses with. */
final class Violations {
    private Violations() {}

    static ProtocolViolation invalid(String text) {
        return new ProtocolViolation(Cause.INVALID_MANDATORY_INFORMATION, text);
    }
}
