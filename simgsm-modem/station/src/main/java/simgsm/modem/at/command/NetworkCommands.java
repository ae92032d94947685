package simgsm.modem.at.command;

import java.util.stream.Collectors;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmeError;
import simgsm.modem.at.state.ModemClock;

/** Network, indicators and clock (TS 27.007, 7 and 8). */
final class NetworkCommands {
    private NetworkCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        KeptSettings.add(
                        table,
                        "+CREG",
                        "(0-2)",
                        "0",
                        "registration: 0 off, 1 home, 2 searching, 3 denied; 1: +CREG at each change, 2: with area and cell")
                .read(NetworkCommands::registration);
        KeptSettings.add(table, "+CGREG", "(0-2)", "0", "packet registration; as +CREG, though no context is set up")
                .read(NetworkCommands::registration);
        KeptSettings.add(table, "+CGATT", "(0,1)", "1", "packet service; accepted, no context is set up")
                .read((client, request) ->
                        request.answer(client.modem().network().isAttached(client) ? 1 : 0));
        table.add(
                        "+COPS",
                        "0|2|3[,format]",
                        "operator: registers, detaches, sets the format (0 long, 1 short, 2 number)")
                .read(NetworkCommands::operator)
                .testWith((client, request) -> {
                    NetworkCodes network = client.modem().network();
                    String name =
                            AtRequest.quoted(client.settings().characterSet.encode(network.operatorName()));
                    request.answer(
                            "(2," + name + "," + name + ",\"" + NetworkCodes.operatorCode() + "\"),,(0,2,3),(0-2)");
                })
                .set(NetworkCommands::setOperator);
        table.add("+CSQ", "", "signal, 0 to 31 or 99, and bit error rate")
                .test("(0-31,99),(99)")
                .execute((client, request) ->
                        request.answer(client.modem().network().signal(), 99));
        table.add("+CIND", "", "indicators: battery, signal, service, message, call, roaming, full memory, call setup")
                .test(NetworkCodes.INDICATORS)
                .read((client, request) -> request.answer(client.modem().network().indicators().stream()
                        .map(String::valueOf)
                        .collect(Collectors.joining(","))));
        KeptSettings.add(
                table, "+CMER", "(0-3),(0),(0),(0-2),(0,1)", "0,0,0,0,0", "+CIEV at each change of an indicator");
        table.add("+CFUN", "0|1|4[,0|1]", "1: on, 0 and 4: detached from the network; 1,1: also restores the settings")
                .read((client, request) ->
                        request.answer(client.modem().network().function()))
                .test("(0,1,4),(0,1)")
                .set(NetworkCommands::function);
        table.add("+CBC", "", "battery: 0, 100 %")
                .test("(0),(100)")
                .execute((client, request) -> request.answer(client.modem().profile().battery));
        table.add("+CSPN", "", "name of the service provider")
                .read((client, request) ->
                        request.answer(AtRequest.quoted(client.modem().network().operatorName()), 0));
        table.add("+CPOWD", "0|1", "detaches, as +CFUN=0; 1 answers NORMAL POWER DOWN in place of OK")
                .setFor(NetworkCommands::powerDown);
        table.add("+CCLK", "\"yy/MM/dd,hh:mm:ss+zz\"", "clock; zz are quarters of an hour")
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
            request.answer(client.modem().terminal().snapshot().powered() ? 0 : 2);
        } else {
            String name = format == 2
                    ? NetworkCodes.operatorCode()
                    : client.settings().characterSet.encode(network.operatorName());
            request.answer(0, format, AtRequest.quoted(name));
        }
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
