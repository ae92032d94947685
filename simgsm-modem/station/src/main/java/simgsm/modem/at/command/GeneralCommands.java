package simgsm.modem.at.command;

import java.util.Locale;
import java.util.function.Function;
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
        table.row("E").execute((client, request) -> client.session().format().setEchoed(request.basicNumber(1) == 1));
        table.row("V").execute((client, request) -> client.session().format().setInWords(request.basicNumber(1) == 1));
        table.row("Q").execute((client, request) -> client.session().format().setQuiet(request.basicNumber(1) == 1));
        table.row("X").execute((client, request) -> client.settings().callProgress = request.basicNumber(4));
        table.row("Z").execute((client, request) -> {
            request.basicNumber(1);
            client.modem().calls().hangUp(client);
            client.reset();
        });
        table.row("&F").execute((client, request) -> client.reset());
        table.row("&V")
                .execute((client, request) -> request.line(
                        client.session().format().describe() + " S0:" + client.settings().ringsBeforeAnswer));
        table.row("S").execute(GeneralCommands::register);
        for (String name : new String[] {"&C", "&D", "&W", "&K", "&S", "L", "M", "N"}) {
            table.row(name).execute((client, request) -> request.basicNumber(9));
        }
        table.row("+CMEE")
                .read((client, request) ->
                        request.answer(client.session().format().errorMode()))
                .set((client, request) -> client.session()
                        .format()
                        .setErrorMode(request.parameters().atMost(1).number(0, 0, 2)));
        table.row("+CSCS")
                .read((client, request) -> request.answer(
                        AtRequest.quoted(client.settings().characterSet.name())))
                .set(GeneralCommands::characterSet);
        table.row("+CLAC")
                .execute((client, request) -> AtCommands.TABLE.rows().forEach(row -> request.line("AT" + row.name())));
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
        table.row("I")
                .execute((client, request) -> client.modem()
                        .profile()
                        .information(client.modem().terminal().model())
                        .forEach(request::line));
        information(table, "GMI", client -> client.modem().profile().manufacturer);
        information(
                table,
                "GMM",
                client ->
                        client.modem().profile().model(client.modem().terminal().model()));
        information(table, "GMR", client -> client.modem().profile().revision);
        information(
                table,
                "GSN",
                client -> client.modem().terminal().station().identity().imei().digits());
        table.row("+GCAP").execute((client, request) -> request.answer("+CGSM"));
        table.row("+WS46")
                .read((client, request) -> request.line("12"))
                .set((client, request) -> request.parameters().atMost(1).number(0, 12, 12));
    }

    /** The command of TS 27.007 and the one of V.250. */
    private static void information(AtCommandTable<AtClient> table, String name, Function<AtClient, String> text) {
        for (String prefix : new String[] {"+C", "+"}) {
            table.row(prefix + name).execute((client, request) -> request.line(text.apply(client)));
        }
    }
}
