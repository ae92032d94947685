package simgsm.cells.network;

import java.util.Optional;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.snapshot.PassingStep;

/** Converts events of mobiles to steps listed by the window. */
final class PassingSteps {
    private PassingSteps() {}

    static Optional<PassingStep> of(MobileEvent event, long nanos) {
        String number = event.mobile().number();
        String cell = event.mobile().cell();
        if (event instanceof MobileEvent.Passed passed) {
            return Optional.of(
                    new PassingStep(nanos, number, passed.step(), passed.from(), passed.to(), passed.figure()));
        } else if (event instanceof MobileEvent.Reported reported) {
            return Optional.of(new PassingStep(
                    nanos, number, PassingStep.Kind.REPORT, reported.serving().cell(), "", reported.number()));
        } else if (event instanceof MobileEvent.Camped camped) {
            return Optional.of(new PassingStep(nanos, number, PassingStep.Kind.RESELECTION, camped.cell(), "", 0));
        } else if (event instanceof MobileEvent.LocationUpdated updated) {
            return Optional.of(
                    new PassingStep(nanos, number, PassingStep.Kind.LOCATION_UPDATE, cell, "", updated.area()));
        } else if (event instanceof MobileEvent.SpeechGap gap) {
            return Optional.of(new PassingStep(nanos, number, PassingStep.Kind.SPEECH_GAP, cell, "", gap.millis()));
        } else if (event instanceof MobileEvent.Ciphered ciphered) {
            return Optional.of(new PassingStep(
                    nanos,
                    number,
                    PassingStep.Kind.CIPHERING,
                    cell,
                    "",
                    ciphered.algorithm().ordinal()));
        } else if (event instanceof MobileEvent.RadioLinkFailed) {
            return Optional.of(new PassingStep(nanos, number, PassingStep.Kind.RADIO_LINK_FAILURE, cell, "", 0));
        }
        return Optional.empty();
    }
}
