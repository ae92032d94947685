package simgsm.center.msc.ss;

import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.ss.SsError;

/** A dialogue that a mobile has begun, for a service. After its end by either side, calls have no effect. */
public interface UssdSession {
    /** The subscriber who asks. */
    Msisdn subscriber();

    /** Shows a text and waits for the user's reply; only one reply at a time. */
    void ask(String text, Consumer<String> reply);

    /** Ends the dialogue with a last text. */
    void end(String text);

    /** Ends the dialogue with an error. */
    void fail(SsError error);
}
