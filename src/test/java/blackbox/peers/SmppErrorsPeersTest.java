package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.Scenario;
import com.cloudhopper.smpp.SmppBindType;
import com.cloudhopper.smpp.SmppConstants;
import com.cloudhopper.smpp.SmppSession;
import com.cloudhopper.smpp.SmppSessionConfiguration;
import com.cloudhopper.smpp.impl.DefaultSmppClient;
import com.cloudhopper.smpp.pdu.BaseSm;
import com.cloudhopper.smpp.pdu.PduRequest;
import com.cloudhopper.smpp.pdu.PduResponse;
import com.cloudhopper.smpp.pdu.SubmitSmResp;
import com.cloudhopper.smpp.tlv.Tlv;
import com.cloudhopper.smpp.type.Address;
import com.cloudhopper.smpp.type.SmppBindException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.smpp.Session;
import org.smpp.TCPIPConnection;
import org.smpp.pdu.BindTransciever;
import org.smpp.pdu.CancelSM;
import org.smpp.pdu.DataSM;
import org.smpp.pdu.DestinationAddress;
import org.smpp.pdu.QuerySM;
import org.smpp.pdu.ReplaceSM;
import org.smpp.pdu.SubmitMultiSM;
import org.smpp.pdu.SubmitSM;
import org.smpp.pdu.SubmitSMResp;
import org.smpp.util.ByteBuffer;

/**
 * Libraries that read the mandatory fields of every response send each command once well and once in error: gosmpp,
 * fiorix/go-smpp, Cloudhopper, OpenSMPP. None loses its session over a refusal.
 */
@Tag("peer")
class SmppErrorsPeersTest {
    private static final String SYSTEM_ID = "peer";
    private static final String PASSWORD = "secret";
    private static final String SOURCE = "111";
    private static final String RECEIVER = "7899";
    private static final String UNKNOWN_ID = "999999";
    /** Longer than any response takes. */
    private static final long PATIENCE_MILLIS = TimeUnit.SECONDS.toMillis(30);

    private static final List<String> ALL = List.of(
            "bind 0x0e",
            "bind 0x00",
            "submit_sm 0x00",
            "data_sm 0x00",
            "submit_multi 0x00",
            "query_sm 0x00",
            "replace_sm 0x00",
            "cancel_sm 0x00",
            "submit_sm 0x0b",
            "data_sm 0x0b",
            "submit_multi 0x0b",
            "query_sm 0x67",
            "replace_sm 0x13",
            "cancel_sm 0x11",
            "enquire_link 0x00",
            "end");

    private final List<String> told = new ArrayList<>();

    private void tell(String command, int status) {
        told.add("%s 0x%02x".formatted(command, status));
    }

    private static Scenario begin(String title) throws IOException {
        Scenario scenario = new Scenario(title);
        Path data = Files.createDirectories(scenario.folder().resolve("data"));
        Files.writeString(data.resolve("smpp-users.properties"), SYSTEM_ID + "=" + PASSWORD + "\n");
        scenario.center("--smpp", "0");
        return scenario;
    }

    @ParameterizedTest
    @ValueSource(strings = {"gosmpp", "fiorix"})
    void aLibraryOfGoReadsEveryRefusal(String library) throws Exception {
        Path program = Peer.LIBRARIES.resolve("smpp_commands");
        Peer.require(Files.isExecutable(program), "gosmpp and fiorix/go-smpp");
        try (Scenario scenario = begin(library + " is refused")) {
            String port = String.valueOf(scenario.smppPort());
            ProcessBuilder run = new ProcessBuilder(program.toString(), library, port, SYSTEM_ID, PASSWORD, RECEIVER);
            List<String> lines =
                    Peer.run(run.redirectErrorStream(true)).text().lines().toList();
            assertEquals(ALL, lines);
        }
    }

    @Test
    void cloudhopperReadsEveryRefusal() throws Exception {
        DefaultSmppClient client = new DefaultSmppClient();
        try (Scenario scenario = begin("Cloudhopper is refused")) {
            SmppSessionConfiguration binding = new SmppSessionConfiguration();
            binding.setType(SmppBindType.TRANSCEIVER);
            binding.setHost("127.0.0.1");
            binding.setPort(scenario.smppPort());
            binding.setSystemId(SYSTEM_ID);
            binding.setPassword("wrong");
            binding.setBindTimeout(PATIENCE_MILLIS);
            try {
                client.bind(binding);
            } catch (SmppBindException refused) {
                tell("bind", refused.getBindResponse().getCommandStatus());
            }
            binding.setPassword(PASSWORD);
            SmppSession session = client.bind(binding);
            tell("bind", 0);
            for (String to : List.of(RECEIVER, "letters")) {
                byMessage(session, to);
            }
            ask(session, "enquire_link", new com.cloudhopper.smpp.pdu.EnquireLink());
            session.unbind(PATIENCE_MILLIS);
            told.add("end");
        } finally {
            client.destroy();
        }
        List<String> known =
                ALL.stream().filter(line -> !line.startsWith("submit_multi")).toList();
        assertEquals(known, told, "Cloudhopper has no submit_multi");
    }

    private PduResponse ask(SmppSession session, String command, PduRequest<?> request) throws Exception {
        var future = session.sendRequestPdu(request, PATIENCE_MILLIS, true);
        assertEquals(true, future.await(PATIENCE_MILLIS), command);
        tell(command, future.getResponse().getCommandStatus());
        return future.getResponse();
    }

    private static Address at(String number) {
        return new Address((byte) 1, (byte) 1, number);
    }

    private static <T extends BaseSm<?>> T from(T message, String to) {
        message.setSourceAddress(at(SOURCE));
        message.setDestAddress(at(to));
        return message;
    }

    private void byMessage(SmppSession session, String to) throws Exception {
        var submit = from(new com.cloudhopper.smpp.pdu.SubmitSm(), to);
        submit.setShortMessage("submit".getBytes(StandardCharsets.US_ASCII));
        String submitted = ((SubmitSmResp) ask(session, "submit_sm", submit)).getMessageId();
        String id = submitted == null || submitted.isEmpty() ? UNKNOWN_ID : submitted;
        var data = from(new com.cloudhopper.smpp.pdu.DataSm(), to);
        data.addOptionalParameter(
                new Tlv(SmppConstants.TAG_MESSAGE_PAYLOAD, "data".getBytes(StandardCharsets.US_ASCII)));
        ask(session, "data_sm", data);
        var query = new com.cloudhopper.smpp.pdu.QuerySm();
        query.setMessageId(id);
        query.setSourceAddress(at(SOURCE));
        ask(session, "query_sm", query);
        var replace = new com.cloudhopper.smpp.pdu.ReplaceSm();
        replace.setSourceAddress(at(SOURCE));
        replace.setMessageId(id);
        replace.setShortMessage("replaced".getBytes(StandardCharsets.US_ASCII));
        ask(session, "replace_sm", replace);
        var cancel = new com.cloudhopper.smpp.pdu.CancelSm();
        cancel.setMessageId(id);
        cancel.setSourceAddress(at(SOURCE));
        cancel.setDestAddress(at(to));
        ask(session, "cancel_sm", cancel);
    }

    @Test
    void openSmppReadsEveryRefusal() throws Exception {
        try (Scenario scenario = begin("OpenSMPP is refused")) {
            Session session = null;
            for (String password : List.of("wrong", PASSWORD)) {
                TCPIPConnection connection = new TCPIPConnection("127.0.0.1", scenario.smppPort());
                connection.setReceiveTimeout(PATIENCE_MILLIS);
                session = new Session(connection);
                BindTransciever bind = new BindTransciever();
                bind.setSystemId(SYSTEM_ID);
                bind.setPassword(password);
                bind.setInterfaceVersion((byte) 0x34);
                tell("bind", session.bind(bind).getCommandStatus());
            }
            for (String to : List.of(RECEIVER, "letters")) {
                byMessage(session, to);
            }
            tell("enquire_link", session.enquireLink().getCommandStatus());
            session.unbind();
            told.add("end");
        }
        assertEquals(ALL, told);
    }

    private static org.smpp.pdu.Address openAt(String number) throws Exception {
        return new org.smpp.pdu.Address((byte) 1, (byte) 1, number);
    }

    private void byMessage(Session session, String to) throws Exception {
        SubmitSM submit = new SubmitSM();
        submit.setSourceAddr(openAt(SOURCE));
        submit.setDestAddr(openAt(to));
        submit.setShortMessage("submit");
        SubmitSMResp submitted = session.submit(submit);
        tell("submit_sm", submitted.getCommandStatus());
        String id = submitted.getCommandStatus() == 0 ? submitted.getMessageId() : UNKNOWN_ID;
        DataSM data = new DataSM();
        data.setSourceAddr(openAt(SOURCE));
        data.setDestAddr(openAt(to));
        data.setMessagePayload(new ByteBuffer("data".getBytes(StandardCharsets.US_ASCII)));
        tell("data_sm", session.data(data).getCommandStatus());
        SubmitMultiSM multi = new SubmitMultiSM();
        multi.setSourceAddr(openAt(SOURCE));
        multi.addDestAddress(new DestinationAddress(openAt(to)));
        multi.setShortMessage("multi");
        tell("submit_multi", session.submitMulti(multi).getCommandStatus());
        QuerySM query = new QuerySM();
        query.setMessageId(id);
        query.setSourceAddr(openAt(SOURCE));
        tell("query_sm", session.query(query).getCommandStatus());
        ReplaceSM replace = new ReplaceSM();
        replace.setMessageId(id);
        replace.setSourceAddr(openAt(SOURCE));
        replace.setShortMessage("replaced");
        tell("replace_sm", session.replace(replace).getCommandStatus());
        CancelSM cancel = new CancelSM();
        cancel.setMessageId(id);
        cancel.setSourceAddr(openAt(SOURCE));
        cancel.setDestAddr(openAt(to));
        tell("cancel_sm", session.cancel(cancel).getCommandStatus());
    }
}
