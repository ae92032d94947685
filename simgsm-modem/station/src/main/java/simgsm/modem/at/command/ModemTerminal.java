package simgsm.modem.at.command;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.Modem;
import simgsm.sim.SimPhoneBook;
import simgsm.station.MobileStation;
import simgsm.station.context.StationEvent;

/**
 * M2 as a modem for AT commands, besides its robot. Keys are signalled, as by real modems: the network makes the
 * tones.
 */
public final class ModemTerminal implements AtTerminal {
    private static final class Keys {
        final Runnable sent;
        int left;

        Keys(int count, Runnable sent) {
            left = count;
            this.sent = sent;
        }
    }

    private final Modem modem;
    private final SimPhoneBook phoneBook = new SimPhoneBook();
    private final Queue<Keys> sending = new ArrayDeque<>();

    public ModemTerminal(Modem modem) {
        this.modem = modem;
    }

    @Override
    public String model() {
        return "M2";
    }

    @Override
    public MobileStation station() {
        return modem.station();
    }

    @Override
    public SimPhoneBook phoneBook() {
        return phoneBook;
    }

    @Override
    public boolean answer() {
        return modem.answer();
    }

    @Override
    public boolean hasCallWaiting() {
        return false;
    }

    @Override
    public void sendKeys(List<DtmfKey> keys, int toneMillis, Runnable sent) {
        sending.add(new Keys(keys.size(), sent));
        keys.forEach(key -> modem.station().signalKey(key, toneMillis));
    }

    @Override
    public void setPower(boolean on) {
        if (on) {
            modem.station().powerOn();
        } else {
            modem.station().powerOff();
        }
    }

    @Override
    public void accept(StationEvent event) {
        if (event instanceof StationEvent.KeyCompleted && !sending.isEmpty()) {
            Keys keys = sending.element();
            if (--keys.left == 0) {
                sending.remove();
                keys.sent.run();
            }
        } else if (event instanceof StationEvent.KeysRefused || event instanceof StationEvent.Released) {
            sending.clear();
        }
    }
}
