package simgsm.modem.at.command;

import java.util.Locale;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmeError;
import simgsm.modem.at.state.CharacterSet;

/** Answers and identity (V.250; TS 27.007, 5 and 9). */
final class GeneralCommands {
    /** S3, S4, S5: the characters that end a line and erase; S7 and others have no effect here. */
    private static final int[] REGISTERS = {0, 0, 0, 13, 10, 8, 2, 60, 2, 6, 14};

    private GeneralCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        answers(table);
        identity(table);
    }

    private static void answers(AtCommandTable<AtClient> table) {
        table.add("E", "0|1", "echo off or on (on)")
                .execute((client, request) -> client.session().format().setEchoed(request.basicNumber(1) == 1));
        table.add("V", "0|1", "results as numbers or in words (words)")
                .execute((client, request) -> client.session().format().setInWords(request.basicNumber(1) == 1));
        table.add("Q", "0|1", "with or without result codes (with)")
                .execute((client, request) -> client.session().format().setQuiet(request.basicNumber(1) == 1));
        table.add("X", "0-4", "below 3 a busy line is reported as NO CARRIER (4)")
                .execute((client, request) -> client.settings().callProgress = request.basicNumber(4));
        table.add("Z", "[0]", "restores what the client has set, and ends its call")
                .execute((client, request) -> {
                    request.basicNumber(1);
                    client.modem().calls().hangUp(client);
                    client.reset();
                });
        table.add("&F", "[0]", "restores what the client has set").execute((client, request) -> client.reset());
        table.add("&V", "", "shows the settings")
                .execute((client, request) -> request.line(
                        client.session().format().describe() + " S0:" + client.settings().ringsBeforeAnswer));
        table.add("S", "n=value|n?", "S0: rings before a call is answered, 0 never (0); the others are read only")
                .execute(GeneralCommands::register);
        for (String name : new String[] {"&C", "&D", "&W", "&K", "&S", "L", "M", "N"}) {
            table.add(name, "n", "accepted, without effect").execute((client, request) -> request.basicNumber(9));
        }
        table.add("+CMEE", "0-2", "errors as ERROR, with numbers or in words (0)")
                .read((client, request) ->
                        request.answer(client.session().format().errorMode()))
                .test("(0-2)")
                .set((client, request) -> client.session()
                        .format()
                        .setErrorMode(request.parameters().atMost(1).number(0, 0, 2)));
        table.add("+CSCS", "\"GSM\"|\"IRA\"|\"UCS2\"|\"HEX\"", "character set of texts and names (IRA)")
                .read((client, request) -> request.answer(
                        AtRequest.quoted(client.settings().characterSet.name())))
                .test("(\"GSM\",\"IRA\",\"UCS2\",\"HEX\")")
                .set(GeneralCommands::characterSet);
        table.add("+CLAC", "", "lists all commands")
                .execute((client, request) -> AtCommands.TABLE.names().forEach(name -> request.line("AT" + name)));
        KeptSettings.addTo(table);
    }

    private static void register(AtClient client, AtRequest request) throws AtException {
        String text = request.command().parameters();
        int end = Math.max(text.indexOf('='), text.indexOf('?'));
        if (end < 1 || end > 3) {
            throw new AtException(AtResult.ERROR);
        }
        int number = Integer.parseInt(text.substring(0, end));
        if (number >= REGISTERS.length) {
            throw new AtException(AtResult.ERROR);
        }
        if (text.charAt(end) == '?') {
            int value = number == 0 ? client.settings().ringsBeforeAnswer : REGISTERS[number];
            request.line(String.format(Locale.ROOT, "%03d", value));
            return;
        }
        String value = text.substring(end + 1);
        if (value.isEmpty() || value.length() > 3 || Integer.parseInt(value) > 255) {
            throw new AtException(AtResult.ERROR);
        }
        if (number == 0) {
            client.settings().ringsBeforeAnswer = Integer.parseInt(value);
        }
    }

    private static void characterSet(AtClient client, AtRequest request) throws AtException {
        String name = request.parameters().atMost(1).text(0);
        for (CharacterSet set : CharacterSet.values()) {
            if (set.name().equalsIgnoreCase(name)) {
                client.settings().characterSet = set;
                return;
            }
        }
        throw new AtException(CmeError.INCORRECT_PARAMETERS);
    }

    private static void identity(AtCommandTable<AtClient> table) {
        table.add("I", "", "manufacturer, model and revision")
                .execute((client, request) -> client.modem()
                        .profile()
                        .information(client.modem().terminal().model())
                        .forEach(request::line));
        for (String name : new String[] {"+CGMI", "+GMI"}) {
            table.add(name, "", "manufacturer")
                    .execute((client, request) -> request.line(client.modem().profile().manufacturer));
        }
        for (String name : new String[] {"+CGMM", "+GMM"}) {
            table.add(name, "", "model: M1 for the phone, M2 for the robot's modem")
                    .execute((client, request) -> request.line(client.modem()
                            .profile()
                            .model(client.modem().terminal().model())));
        }
        for (String name : new String[] {"+CGMR", "+GMR"}) {
            table.add(name, "", "revision")
                    .execute((client, request) -> request.line(client.modem().profile().revision));
        }
        for (String name : new String[] {"+CGSN", "+GSN"}) {
            table.add(name, "", "IMEI")
                    .execute((client, request) -> request.line(
                            client.modem().terminal().identity().imei().digits()));
        }
        table.add("+GCAP", "", "capabilities").execute((client, request) -> request.answer("+CGSM"));
        table.add("+WS46", "12", "radio technology: GSM")
                .read((client, request) -> request.line("12"))
                .test("(12)")
                .set((client, request) -> request.parameters().atMost(1).number(0, 12, 12));
    }
}
