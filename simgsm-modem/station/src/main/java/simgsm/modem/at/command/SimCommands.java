package simgsm.modem.at.command;

import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmeError;
import simgsm.modem.at.state.SimFiles;

/** The SIM (TS 27.007, 5, 7 and 8). */
final class SimCommands {
    private SimCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("+CPIN")
                .read((client, request) -> request.answer("READY"))
                .setFor((client, request) -> new AtResult.EquipmentError(CmeError.OPERATION_NOT_ALLOWED));
        table.row("+CIMI")
                .execute((client, request) -> request.line(
                        client.modem().terminal().station().identity().imsi().digits()));
        table.row("+CNUM").execute((client, request) -> {
            String number =
                    client.modem().terminal().station().identity().number().toString();
            request.answer("\"\"", AtRequest.quoted(number), AddressType.of(number));
        });
        table.row("+CCID")
                .execute((client, request) -> request.line(
                        client.modem().profile().cardNumber(files(client).iccid())));
        table.row("+SPIC").execute((client, request) -> request.answer(3, 10, 3, 10));
        table.row("+CPINR").execute((client, request) -> {
            request.answer("SIM PIN", 3, 3);
            request.answer("SIM PUK", 10, 10);
        });
        table.row("+CLCK").set(SimCommands::lock);
        table.row("+CRSM").set(SimCommands::restrictedAccess);
    }

    private static SimFiles files(AtClient client) {
        return new SimFiles(
                client.modem().terminal().station().identity(),
                client.modem().network().operatorName());
    }

    private static void lock(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(4);
        int mode = parameters.number(1, 0, 2);
        if (!parameters.text(0).equalsIgnoreCase("SC") || mode != 2) {
            throw new AtException(CmeError.OPERATION_NOT_SUPPORTED);
        }
        request.answer(0);
    }

    private static void restrictedAccess(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(7);
        SimFiles.Answer answer = files(client)
                .access(
                        parameters.number(0, 0, 255),
                        parameters.number(1, 0, 0xffff, 0),
                        parameters.number(2, 0, 255, 0),
                        parameters.number(3, 0, 255, 0),
                        parameters.number(4, 0, 255, 0));
        if (answer.data().isEmpty()) {
            request.answer(answer.status1(), answer.status2());
        } else {
            request.answer(answer.status1(), answer.status2(), AtRequest.quoted(answer.data()));
        }
    }
}
