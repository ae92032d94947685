package simgsm.ui.scope;

import java.util.function.Function;
import simgsm.dtmf.ReceiverTrace;
import simgsm.dtmf.ToneTrace;

/** The two receivers of a tone scope. */
enum ShownReceiver {
    MODEM("scope.receiver.modem", ToneTrace::modem),
    CLASSIC("scope.receiver.classic", ToneTrace::classic);

    /** Key of the text with its name; the tool tip's ends with ".tip". */
    final String key;

    private final Function<ToneTrace, ReceiverTrace> part;

    ShownReceiver(String key, Function<ToneTrace, ReceiverTrace> part) {
        this.key = key;
        this.part = part;
    }

    /** What this receiver made of the sound. */
    ReceiverTrace of(ToneTrace trace) {
        return part.apply(trace);
    }
}
