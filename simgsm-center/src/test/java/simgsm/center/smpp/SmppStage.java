package simgsm.center.smpp;

import java.nio.charset.StandardCharsets;
import java.util.List;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppPdu;

/** Applications and the centre, with time moved by hand. */
abstract class SmppStage {
    static final String SERVICE = "5550300";

    final TestCenter network = new TestCenter();

    TestCenter.Application receiver(String range) {
        return network.bound(SmppCommand.BIND_RECEIVER, "receiver", range);
    }

    TestCenter.Application sender() {
        return network.bound(SmppCommand.BIND_TRANSMITTER, "sender", "");
    }

    static String textOf(SmppPdu.Message delivery) {
        return new String(delivery.message().shortMessage().toArray(), StandardCharsets.ISO_8859_1);
    }

    static List<String> texts(TestCenter.Application application) {
        return application.all(SmppPdu.Message.class).stream()
                .map(SmppStage::textOf)
                .toList();
    }

    static int bindReceiver(TestCenter.Application application, String systemId, String range) {
        application.say(new SmppPdu.Bind(SmppCommand.BIND_RECEIVER, 1, systemId, "", "", 0x34, range));
        return application.all(SmppPdu.BindResponse.class).get(0).status();
    }

    static int bind(TestCenter.Application application, String systemId, String password) {
        application.say(new SmppPdu.Bind(SmppCommand.BIND_TRANSCEIVER, 1, systemId, password, "", 0x34, ""));
        return application.last(SmppPdu.BindResponse.class).status();
    }
}
