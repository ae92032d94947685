package simgsm.modem.at.command;

import java.util.HashMap;
import java.util.Map;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;

/** +DTMF: the far end's keys, for clients that have set +DDET. Keys are decoded only if there is such a client. */
final class KeyCodes implements DtmfListener {
    /** The key last reported to a client, and its start. */
    private record Reported(DtmfKey key, long sample, boolean isReported) {}

    private static final int SAMPLES_PER_MILLI = 8;

    private final AtModem modem;
    private final DtmfReceiver receiver = new DtmfReceiver(this);
    private final Map<AtClient, Reported> last = new HashMap<>();

    KeyCodes(AtModem modem) {
        this.modem = modem;
    }

    void hear(short[] samples) {
        if (modem.clients().stream().anyMatch(client -> client.settings().reportsKeys)) {
            receiver.accept(samples);
        }
    }

    /** Starts a call. */
    void reset() {
        receiver.reset();
        last.clear();
    }

    void callEnded() {
        receiver.finish();
        reset();
    }

    @Override
    public void keyDecided(DtmfDigit digit) {
        for (AtClient client : modem.clients()) {
            if (client.settings().reportsKeys) {
                boolean wanted = !isTooSoon(client, digit);
                last.put(client, new Reported(digit.key(), digit.startedAtSample(), wanted));
                if (wanted && !client.settings().reportsKeyMillis) {
                    client.report("+DTMF: " + digit.key().symbol());
                }
            }
        }
    }

    @Override
    public void keyEnded(DtmfDigit digit) {
        for (AtClient client : modem.clients()) {
            Reported reported = last.get(client);
            if (client.settings().reportsKeyMillis && reported != null && reported.isReported()) {
                client.report("+DTMF: " + digit.key().symbol() + "," + Math.round(digit.durationMillis()));
            }
        }
    }

    private boolean isTooSoon(AtClient client, DtmfDigit digit) {
        Reported before = last.get(client);
        return before != null
                && before.key() == digit.key()
                && digit.startedAtSample() - before.sample()
                        < (long) client.settings().equalKeysMillis * SAMPLES_PER_MILLI;
    }
}
