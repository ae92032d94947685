package simgsm.station.call;

import simgsm.air.TransactionIdentifier;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;

/** Speech and keys of the current call, and the network's tones before or after them. */
final class CallSpeech {
    private final StationContext context;
    private final SpeechPath path;
    private final KeySignalling keys;
    private final Runnable farEndSilent;
    private boolean isForTones;

    /** @param farEndSilent as in {@link SpeechPath#start} */
    CallSpeech(StationContext context, SpeechPath path, KeySignalling keys, Runnable farEndSilent) {
        this.context = context;
        this.path = path;
        this.keys = keys;
        this.farEndSilent = farEndSilent;
    }

    /** Opens the path while the call is not active, if the network has announced tones. */
    void attach(boolean tonesAnnounced) {
        if (tonesAnnounced) {
            path.start(farEndSilent);
            setForTones(true);
        }
    }

    /** The call with this transaction is active. */
    void start(TransactionIdentifier transaction) {
        setForTones(false);
        path.start(farEndSilent);
        keys.begin(transaction);
    }

    void stop() {
        path.stop();
        keys.end();
        setForTones(false);
    }

    private void setForTones(boolean forTones) {
        if (isForTones != forTones) {
            isForTones = forTones;
            context.events().add(new StationEvent.NetworkPlaysTones(forTones));
        }
    }
}
