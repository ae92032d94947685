package simgsm.modem.at.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simgsm.air.Imsi;
import simgsm.air.LocationArea;
import simgsm.station.ServingCell;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;

/** Registration and indicators, and their unsolicited codes +CREG and +CIEV. */
final class NetworkCodes {
    /** Indicators in the order of +CIND (TS 27.007, 8.9), with their ranges. */
    static final String INDICATORS = "(\"battchg\",(0-5)),(\"signal\",(0-5)),(\"service\",(0,1)),(\"message\",(0,1)),"
            + "(\"call\",(0,1)),(\"roam\",(0,1)),(\"smsfull\",(0,1)),(\"callsetup\",(0-3))";

    /** Identity of the test network's one cell. */
    private static final int OWN_CELL = 1;

    private static final String DEFAULT_NAME = "SimGSM";
    private static final int FULL = 5;
    /** +CSQ of a terminal with a link, -63 dBm; without cells no radio is simulated. */
    private static final int SIGNAL_WITH_LINK = 25;

    private static final int SIGNAL_UNKNOWN = 99;
    private static final int SIGNAL_MOST = 31;
    private static final int SIGNAL_ZERO_DBM = -113;

    private final AtModem modem;
    private int functionWhenOff;
    private int lastRegistration = -1;
    private String lastPlace = "";
    private List<Integer> lastIndicators = List.of();

    NetworkCodes(AtModem modem) {
        this.modem = modem;
    }

    private StationSnapshot station() {
        return modem.terminal().station().snapshot();
    }

    /** Registers or detaches. @param function answer of +CFUN from now on */
    void setPower(boolean on, int function) {
        functionWhenOff = on ? 0 : function;
        modem.terminal().setPower(on);
    }

    /** The value set by +CFUN; 0 for a terminal switched off by its user. */
    int function() {
        return station().powered() ? 1 : functionWhenOff;
    }

    /** 0 off, 1 registered at home, 2 searching, 3 denied (TS 27.007, 7.2). */
    int registration() {
        if (!station().powered() || !station().card().isReady()) {
            return 0;
        }
        if (station().registered()) {
            return 1;
        }
        return station().rejectCause().isPresent() ? 3 : 2;
    }

    /** State, and for mode 2 the place of registration. */
    String registration(int mode) {
        int state = registration();
        int area = station().cell().map(ServingCell::areaCode).orElse(LocationArea.TEST.areaCode());
        int cell = station().cell().map(ServingCell::identity).orElse(OWN_CELL);
        return mode == 2 && state == 1
                ? String.format(Locale.ROOT, "%d,\"%04X\",\"%04X\"", state, area, cell)
                : Integer.toString(state);
    }

    /** The client's mode of +CREG or +CGREG. */
    int mode(AtClient client, String command) {
        return Integer.parseInt(KeptSettings.kept(client, command));
    }

    /** As above; there is no packet service, so +CGREG equals +CREG while the client wants to be attached. */
    String registration(AtClient client, String command) {
        return command.equals("+CREG") || isAttached(client) ? registration(mode(client, command)) : "0";
    }

    boolean isAttached(AtClient client) {
        return registration() == 1 && KeptSettings.kept(client, "+CGATT").equals("1");
    }

    /** 0 to 31, from -113 dBm in steps of 2 dB, or 99. */
    int signal() {
        if (!station().powered() || !station().linkUp()) {
            return SIGNAL_UNKNOWN;
        }
        return station()
                .cell()
                .map(cell -> Math.max(0, Math.min(SIGNAL_MOST, (cell.dbm() - SIGNAL_ZERO_DBM) / 2)))
                .orElse(SIGNAL_WITH_LINK);
    }

    String operatorName() {
        return station().networkName().isEmpty() ? DEFAULT_NAME : station().networkName();
    }

    static String operatorCode() {
        return Imsi.TEST_NETWORK;
    }

    List<Integer> indicators() {
        boolean isRegistered = station().registered();
        List<Integer> values = new ArrayList<>();
        values.add(FULL);
        values.add(
                signal() == SIGNAL_UNKNOWN
                        ? 0
                        : station().cell().map(cell -> cell.bars(FULL)).orElse(FULL));
        values.add(isRegistered ? 1 : 0);
        values.add(modem.messages().hasUnread() ? 1 : 0);
        values.add(station().callState() == MobileCallState.ACTIVE ? 1 : 0);
        values.add(0);
        values.add(modem.messages().isFull() ? 1 : 0);
        values.add(modem.calls().setup());
        return values;
    }

    /** Reports changes. */
    void check() {
        // mode 2 also reports another cell (TS 27.007, 7.2)
        if (!registration(2).equals(lastPlace)) {
            boolean isOtherState = registration() != lastRegistration;
            lastRegistration = registration();
            lastPlace = registration(2);
            for (AtClient client : modem.clients()) {
                for (String name : List.of("+CREG", "+CGREG")) {
                    if (mode(client, name) > (isOtherState ? 0 : 1)) {
                        client.report(name + ": " + registration(client, name));
                    }
                }
            }
        }
        if (registration() == 1) {
            modem.clients().forEach(AtClient::registered);
        }
        List<Integer> now = indicators();
        for (int i = 0; i < lastIndicators.size(); i++) {
            if (!now.get(i).equals(lastIndicators.get(i))) {
                report("+CIEV: " + (i + 1) + "," + now.get(i));
            }
        }
        lastIndicators = now;
    }

    private void report(String line) {
        modem.clients().stream()
                .filter(client -> KeptSettings.kept(client, "+CMER").matches("[1-3],0,0,[12].*"))
                .forEach(client -> client.report(line));
    }
}
