package simgsm.modem.at.command;

import java.util.function.Consumer;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.AtSession;
import simgsm.modem.at.state.ClientSettings;

/** One connected client: its dialogue and settings. */
public final class AtClient {
    private final AtModem modem;
    private final AtSession<AtClient> session;
    private ClientSettings settings;
    private boolean isBooting;

    AtClient(AtModem modem, Consumer<byte[]> output) {
        this.modem = modem;
        settings = newSettings();
        session = new AtSession<>(AtCommands.TABLE, this, modem.timers(), output);
    }

    /** Receives octets from the client. */
    public void received(byte[] octets) {
        session.received(octets);
    }

    /** False while the client must be held back. */
    public boolean wantsInput() {
        return session.wantsInput();
    }

    /** True if a command has no final result yet. */
    public boolean isPerforming() {
        return session.isPerforming();
    }

    /** The client has disconnected. */
    public void close() {
        session.close();
        modem.left(this);
    }

    AtModem modem() {
        return modem;
    }

    AtSession<AtClient> session() {
        return session;
    }

    ClientSettings settings() {
        return settings;
    }

    private ClientSettings newSettings() {
        ClientSettings fresh = new ClientSettings();
        if (modem.profile().reportsMessages()) {
            fresh.indicationMode = 2;
            fresh.deliverMode = 1;
        }
        return fresh;
    }

    /** Performs ATZ and AT&F. */
    void reset() {
        settings = newSettings();
        session.resetFormat();
        modem.settingsChanged();
    }

    /** Reports the codes after power-on; the rest follows after registration. */
    void boot() {
        modem.profile().bootCodes.forEach(this::report);
        isBooting = modem.profile().boots();
        if (isBooting) {
            report("+CPIN: " + SimCommands.demand(SimCommands.status(this)));
        }
        modem.network().check();
    }

    /** The modem is registered. */
    void registered() {
        if (isBooting) {
            isBooting = false;
            report("Call Ready");
            report("SMS Ready");
        }
    }

    void report(String line) {
        session.report(line);
    }

    void reportTogether(Runnable reports) {
        session.reportTogether(reports);
    }

    void announce(String line) {
        session.announce(line);
    }

    void report(AtResult code) {
        session.report(code);
    }
}
