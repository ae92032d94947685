package simgsm.modem.at.command;

import simgsm.air.Msisdn;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmsError;
import simgsm.modem.at.state.ClientSettings;
import simgsm.modem.at.state.SimMemory;
import simgsm.sms.ChannelList;

/** Commands for the settings of short messages (TS 27.005, 3.2 and 3.3). */
final class MessageSettingCommands {
    private static final AtResult REFUSED = new AtResult.MessageError(CmsError.OPERATION_NOT_SUPPORTED);
    private static final int SUBMIT = 0x01;
    private static final int TYPE_MASK = 0x03;
    private static final int VALIDITY_MASK = 0x18;
    private static final int VALIDITY_ENHANCED = 0x08;
    private static final int HAS_HEADER = 0x40;

    private MessageSettingCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("+CMGF")
                .read((client, request) -> request.answer(client.settings().textMode ? 1 : 0))
                .set((client, request) -> client.settings().textMode = number(request, 1) == 1);
        table.row("+CSMS")
                .read((client, request) -> request.answer(client.settings().acknowledges ? 1 : 0, 1, 1, 1))
                .set(MessageSettingCommands::service);
        table.row("+CPMS")
                .read((client, request) -> request.answer(memory(client), memory(client), memory(client)))
                .set(MessageSettingCommands::memories);
        table.row("+CNMI").read(MessageSettingCommands::tellIndications).set(MessageSettingCommands::indications);
        submissions(table);
    }

    private static void submissions(AtCommandTable<AtClient> table) {
        table.row("+CSCA")
                .read((client, request) -> request.answer(
                        AtRequest.quoted(client.settings()
                                .characterSet
                                .encode(client.modem()
                                        .messages()
                                        .serviceCenter()
                                        .toString())),
                        AddressType.of(client.modem().messages().serviceCenter().toString())))
                .set(MessageSettingCommands::serviceCenter);
        table.row("+CSMP")
                .read(MessageSettingCommands::tellSubmitParameters)
                .set(MessageSettingCommands::submitParameters);
        table.row("+CSDH")
                .read((client, request) -> request.answer(client.settings().showsHeader ? 1 : 0))
                .set((client, request) -> client.settings().showsHeader = number(request, 1) == 1);
        table.row("+CSCB")
                .read((client, request) -> request.answer(0, AtRequest.quoted("" + client.settings().channels), "\"\""))
                .set(MessageSettingCommands::channels);
    }

    private static int number(AtRequest request, int most) throws AtException {
        return request.parameters().refusing(REFUSED).atMost(1).number(0, 0, most);
    }

    private static String used(AtClient client) {
        return client.modem().messages().memory().used() + "," + SimMemory.CAPACITY;
    }

    private static String memory(AtClient client) {
        return "\"SM\"," + used(client);
    }

    private static void service(AtClient client, AtRequest request) throws AtException {
        client.settings().acknowledges = number(request, 1) == 1;
        request.answer(1, 1, 1);
    }

    private static void memories(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(REFUSED).atMost(3);
        for (int i = 0; i < Math.max(1, parameters.count()); i++) {
            if (!parameters.text(i).equalsIgnoreCase("SM")) {
                throw parameters.refused();
            }
        }
        request.answer(used(client), used(client), used(client));
    }

    private static void tellIndications(AtClient client, AtRequest request) {
        ClientSettings now = client.settings();
        request.answer(now.indicationMode, now.deliverMode, now.broadcastMode, now.reportMode, now.bufferMode);
    }

    private static void indications(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(REFUSED).atMost(5);
        ClientSettings settings = client.settings();
        int mode = parameters.number(0, 0, 2, settings.indicationMode);
        int deliver = parameters.number(1, 0, 3, settings.deliverMode);
        int broadcast = parameters.number(2, 0, 2, settings.broadcastMode);
        int report = parameters.number(3, 0, 2, settings.reportMode);
        int buffer = parameters.number(4, 0, 1, settings.bufferMode);
        if (broadcast == 1) {
            throw parameters.refused();
        }
        settings.indicationMode = mode;
        settings.deliverMode = deliver;
        settings.broadcastMode = broadcast;
        settings.reportMode = report;
        settings.bufferMode = buffer;
        client.modem().messages().indicationsSet(client);
    }

    private static void serviceCenter(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(REFUSED).atMost(2);
        try {
            String number = client.settings().characterSet.decodeNumber(parameters.text(0));
            client.modem().messages().setServiceCenter(Msisdn.parse(number));
        } catch (IllegalArgumentException notANumber) {
            throw AtException.ofMessage(CmsError.INVALID_TEXT_PARAMETER);
        }
    }

    private static void tellSubmitParameters(AtClient client, AtRequest request) {
        ClientSettings now = client.settings();
        request.answer(now.submitFirstOctet, now.submitValidity, now.submitProtocol, now.submitCoding);
    }

    private static void submitParameters(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(REFUSED).atMost(4);
        ClientSettings settings = client.settings();
        int first = parameters.number(0, 0, 255, settings.submitFirstOctet);
        int validity = parameters.number(1, 0, 255, settings.submitValidity);
        int protocol = parameters.number(2, 0, 255, settings.submitProtocol);
        int coding = parameters.number(3, 0, 255, settings.submitCoding);
        boolean isAbsolute = (first & VALIDITY_MASK) == VALIDITY_MASK;
        boolean isEnhanced = (first & VALIDITY_MASK) == VALIDITY_ENHANCED;
        if ((first & TYPE_MASK) != SUBMIT || isAbsolute || isEnhanced || (first & HAS_HEADER) != 0) {
            throw parameters.refused();
        }
        settings.submitFirstOctet = first;
        settings.submitValidity = validity;
        settings.submitProtocol = protocol;
        settings.submitCoding = coding;
    }

    private static void channels(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(REFUSED).atMost(3);
        int mode = parameters.number(0, 0, 1);
        String list = parameters.text(1);
        if (mode == 1 && !list.isEmpty()) {
            throw parameters.refused();
        }
        try {
            client.settings().channels =
                    list.isEmpty() ? mode == 1 ? ChannelList.ALL : ChannelList.NONE : ChannelList.parse(list);
        } catch (IllegalArgumentException wrong) {
            throw parameters.refused();
        }
    }
}
