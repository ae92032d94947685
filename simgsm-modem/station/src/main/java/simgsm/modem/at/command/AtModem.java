package simgsm.modem.at.command;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.AtSound;
import simgsm.modem.at.state.ModemClock;
import simgsm.modem.at.state.PhoneBooks;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timers;

/**
 * The AT side of one terminal, shared by all its clients, which receive the terminal's events as unsolicited codes.
 * Time is given by advancing {@link #timers}. Owned by the thread that owns the station.
 */
public final class AtModem {
    private final AtTerminal terminal;
    private final AtProfile profile;
    private final Timers timers = new Timers();
    private final List<AtClient> clients = new ArrayList<>();
    private final ModemClock clock;
    private final CallCodes calls;
    private final KeyCodes keys;
    private final NetworkCodes network;
    private final MessageCodes messages;
    private final Submissions submissions;
    private final PhoneBooks books;
    private final UssdCodes ussd;
    private final PendingServiceCommand services;
    private final AtSound sound = new AtSound();

    /** @param wallClock for AT+CCLK */
    public AtModem(AtTerminal terminal, AtProfile profile, InstantSource wallClock) {
        this.terminal = terminal;
        this.profile = profile;
        clock = new ModemClock(wallClock);
        books = new PhoneBooks(terminal.station().identity().number(), terminal.phoneBook());
        keys = new KeyCodes(this);
        ussd = new UssdCodes(this);
        services = new PendingServiceCommand(terminal);
        calls = new CallCodes(this);
        network = new NetworkCodes(this);
        messages = new MessageCodes(this);
        submissions = new Submissions(terminal);
        terminal.station().setAdded(sound);
    }

    /** Connects a client. @param output receives octets to send to it */
    public AtClient connect(Consumer<byte[]> output) {
        AtClient client = new AtClient(this, output);
        clients.add(client);
        settingsChanged();
        client.boot();
        return client;
    }

    void left(AtClient client) {
        clients.remove(client);
        settingsChanged();
    }

    /** Receives each event of the terminal's station. */
    public void accept(StationEvent event) {
        terminal.accept(event);
        if (event instanceof StationEvent.SpeechReceived speech) {
            keys.hear(speech.samples());
            sound.heard(speech.samples());
            return;
        }
        if (event instanceof StationEvent.NetworkTimeReceived received) {
            clock.set(received.time());
        } else if (event instanceof StationEvent.OfCall ofCall) {
            calls.accept(ofCall);
        } else if (event instanceof StationEvent.KeysRefused) {
            calls.keysRefused();
        } else if (event instanceof StationEvent.OfUssd ofUssd) {
            if (!services.accept(ofUssd)) {
                ussd.accept(ofUssd);
            }
        } else if (event instanceof StationEvent.OfSubmittedMessage submitted) {
            submissions.accept(submitted);
        } else if (event instanceof StationEvent.OfMessage message) {
            messages.accept(message);
        }
        network.check();
    }

    /** The modem's time; the driver advances it. */
    public Timers timers() {
        return timers;
    }

    List<AtClient> clients() {
        return List.copyOf(clients);
    }

    void settingsChanged() {
        messages.settingsChanged();
    }

    AtTerminal terminal() {
        return terminal;
    }

    AtProfile profile() {
        return profile;
    }

    UssdCodes ussd() {
        return ussd;
    }

    ModemClock clock() {
        return clock;
    }

    CallCodes calls() {
        return calls;
    }

    PendingServiceCommand services() {
        return services;
    }

    KeyCodes keys() {
        return keys;
    }

    NetworkCodes network() {
        return network;
    }

    MessageCodes messages() {
        return messages;
    }

    Submissions submissions() {
        return submissions;
    }

    /** The sound of calls for a client's program. */
    public AtSound sound() {
        return sound;
    }

    PhoneBooks books() {
        return books;
    }
}
