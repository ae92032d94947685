package simgsm.modem.at.command;

import java.util.stream.Collectors;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmeError;
import simgsm.modem.at.state.ModemClock;

/** Network, indicators and clock (TS 27.007, 7 and 8). */
final class NetworkCommands {
    private NetworkCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("+CREG").read(NetworkCommands::registration);
        table.row("+CGREG").read(NetworkCommands::registration);
        table.row("+CGATT")
                .read((client, request) ->
                        request.answer(client.modem().network().isAttached(client) ? 1 : 0));
        table.row("+COPS")
                .read(NetworkCommands::operator)
                .testWith(NetworkCommands::operators)
                .set(NetworkCommands::setOperator);
        table.row("+CSQ")
                .execute((client, request) ->
                        request.answer(client.modem().network().signal(), 99));
        table.row("+CIND")
                .test(NetworkCodes.INDICATORS)
                .read((client, request) -> request.answer(client.modem().network().indicators().stream()
                        .map(String::valueOf)
                        .collect(Collectors.joining(","))));
        power(table);
    }

    private static void power(AtCommandTable<AtClient> table) {
        table.row("+CFUN")
                .read((client, request) ->
                        request.answer(client.modem().network().function()))
                .set(NetworkCommands::function);
        table.row("+CBC")
                .execute((client, request) -> request.answer(client.modem().profile().battery));
        table.row("+CSPN")
                .read((client, request) ->
                        request.answer(AtRequest.quoted(client.modem().network().operatorName()), 0));
        table.row("+CPOWD").setFor(NetworkCommands::powerDown);
        table.row("+CCLK")
                .read((client, request) -> request.answer(AtRequest.quoted(
                        ModemClock.format(client.modem().clock().now()))))
                .set(NetworkCommands::setClock);
    }

    private static void registration(AtClient client, AtRequest request) {
        NetworkCodes network = client.modem().network();
        String name = request.command().name();
        request.answer(network.mode(client, name), network.registration(client, name));
    }

    private static void operator(AtClient client, AtRequest request) {
        NetworkCodes network = client.modem().network();
        int format = client.settings().operatorFormat;
        if (network.registration() != 1) {
            request.answer(client.modem().terminal().station().snapshot().powered() ? 0 : 2);
        } else {
            String name = format == 2
                    ? NetworkCodes.operatorCode()
                    : client.settings().characterSet.encode(network.operatorName());
            request.answer(0, format, AtRequest.quoted(name));
        }
    }

    /** The one operator, with access technology 0 (GSM), without which gsm-utils 1.10 reads no list; SIM800 has none. */
    private static void operators(AtClient client, AtRequest request) {
        String name = AtRequest.quoted(
                client.settings().characterSet.encode(client.modem().network().operatorName()));
        String technology = client.modem().profile() == AtProfile.SIM800 ? "" : ",0";
        request.answer("(2," + name + "," + name + ",\"" + NetworkCodes.operatorCode() + "\"" + technology
                + "),,(0,2,3),(0-2)");
    }

    private static void setOperator(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(4);
        int mode = parameters.number(0, 0, 4);
        int format = parameters.number(1, 0, 2, client.settings().operatorFormat);
        if (mode == 1 || mode == 4) {
            boolean isOurs = parameters.text(2).equals(NetworkCodes.operatorCode())
                    || parameters.text(2).equals(client.modem().network().operatorName());
            if (!isOurs && mode == 1) {
                throw new AtException(CmeError.NO_NETWORK_SERVICE);
            }
        }
        client.settings().operatorFormat = format;
        if (mode != 3) {
            client.modem().network().setPower(mode != 2, 1);
        }
    }

    private static void function(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(2);
        int function = parameters.number(0, 0, 4);
        if (function != 0 && function != 1 && function != 4) {
            throw new AtException(CmeError.OPERATION_NOT_SUPPORTED);
        }
        boolean restores = parameters.number(1, 0, 1, 0) == 1;
        if (function != 1) {
            client.modem().calls().hangUp(client);
        }
        client.modem().network().setPower(function == 1, function);
        if (restores) {
            client.reset();
            client.boot();
        }
    }

    private static AtResult powerDown(AtClient client, AtRequest request) throws AtException {
        boolean isNormal = request.parameters().atMost(1).number(0, 0, 1) == 1;
        client.modem().calls().hangUp(client);
        client.modem().network().setPower(false, 0);
        return isNormal ? AtResult.NORMAL_POWER_DOWN : AtResult.OK;
    }

    private static void setClock(AtClient client, AtRequest request) throws AtException {
        try {
            client.modem().clock().set(request.parameters().atMost(1).text(0));
        } catch (IllegalArgumentException wrong) {
            throw new AtException(CmeError.INCORRECT_PARAMETERS);
        }
    }
}
