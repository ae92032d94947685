package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.URLDecoder;
import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jsmpp.bean.AlertNotification;
import org.jsmpp.bean.Alphabet;
import org.jsmpp.bean.BindType;
import org.jsmpp.bean.DataSm;
import org.jsmpp.bean.DeliverSm;
import org.jsmpp.bean.ESMClass;
import org.jsmpp.bean.GeneralDataCoding;
import org.jsmpp.bean.NumberingPlanIndicator;
import org.jsmpp.bean.RegisteredDelivery;
import org.jsmpp.bean.SMSCDeliveryReceipt;
import org.jsmpp.bean.TypeOfNumber;
import org.jsmpp.session.BindParameter;
import org.jsmpp.session.DataSmResult;
import org.jsmpp.session.MessageReceiverListener;
import org.jsmpp.session.SMPPSession;
import org.jsmpp.session.Session;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** SMPP applications that were written elsewhere drive the robot: smpplib, node-smpp, jSMPP and Kannel. */
@Tag("peer")
class SmppPeersTest {
    private static final String APPLICATION = "5550300";
    private static final String ORDER = "** #**20 **";
    private static int nextPort = 20_000 + new Random().nextInt(10_000);
    private static final String DONE = "3 Done: #**20. Stopped at 0.200";

    private static RunningProgram begin(Scenario scenario) {
        scenario.center("--smpp", "0");
        return scenario.robot("empty.map", "--speed", "20");
    }

    @Test
    void smpplibDrivesTheRobot() throws Exception {
        Peer.require(Peer.PYTHON.run("-c", "import smpplib").status() == 0, "smpplib (Python)");
        scriptDrivesTheRobot("smpplib", Peer.PYTHON, "smpplib_order.py");
    }

    @Test
    void nodeSmppDrivesTheRobot() throws Exception {
        Peer.require(Peer.NODE.run("-e", "require('smpp')").status() == 0, "smpp (Node)");
        scriptDrivesTheRobot("node-smpp", Peer.NODE, "node_smpp_order.js");
    }

    private static void scriptDrivesTheRobot(String title, Peer interpreter, String script) throws Exception {
        try (Scenario scenario = new Scenario(title + " drives the robot")) {
            RunningProgram robot = begin(scenario);
            String port = String.valueOf(scenario.smppPort());
            String printed = interpreter
                    .run(Peer.source(script), port, APPLICATION, Scenario.ROBOT, ORDER)
                    .expectSuccess();
            assertTrue(printed.contains("submitted "), printed);
            assertTrue(printed.contains("receipt DELIVRD"), printed);
            assertTrue(printed.contains("reply " + DONE), printed);
            robot.expect("order", "verdict", "accepted");
        }
    }

    /** @param isStopped whether the centre is stopped for 1.5 s as the application begins */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void jsmppDrivesTheRobot(boolean isStopped) throws Exception {
        try (Scenario scenario = new Scenario("jSMPP drives the robot")) {
            RunningProgram center = scenario.center("--smpp", "0");
            RunningProgram robot = scenario.robot("empty.map", "--speed", "20");
            int port = scenario.smppPort();
            if (isStopped) {
                StoppedServerTest.stop(center);
            }
            BlockingQueue<String> receipts = new LinkedBlockingQueue<>();
            BlockingQueue<String> replies = new LinkedBlockingQueue<>();
            SMPPSession session = new SMPPSession();
            session.setTransactionTimer(TimeUnit.SECONDS.toMillis(RunningProgram.PATIENCE_SECONDS));
            session.setMessageReceiverListener(new MessageReceiverListener() {
                @Override
                public void onAcceptDeliverSm(DeliverSm delivered) {
                    String text = new String(delivered.getShortMessage(), StandardCharsets.ISO_8859_1);
                    (delivered.isSmscDeliveryReceipt() ? receipts : replies).add(text);
                }

                @Override
                public void onAcceptAlertNotification(AlertNotification notification) {}

                @Override
                public DataSmResult onAcceptDataSm(DataSm data, Session source) {
                    return null;
                }
            });
            session.connectAndBind("127.0.0.1", port, binding());
            String id = session.submitShortMessage(
                            "",
                            TypeOfNumber.INTERNATIONAL,
                            NumberingPlanIndicator.ISDN,
                            APPLICATION,
                            TypeOfNumber.INTERNATIONAL,
                            NumberingPlanIndicator.ISDN,
                            Scenario.ROBOT,
                            new ESMClass(),
                            (byte) 0,
                            (byte) 0,
                            null,
                            null,
                            new RegisteredDelivery(SMSCDeliveryReceipt.SUCCESS_FAILURE),
                            (byte) 0,
                            new GeneralDataCoding(Alphabet.ALPHA_DEFAULT),
                            (byte) 0,
                            ORDER.getBytes(StandardCharsets.US_ASCII))
                    .getMessageId();
            assertTrue(taken(receipts).contains("id:" + id), id);
            assertTrue(taken(replies).startsWith(DONE));
            robot.expect("order", "verdict", "accepted");
            session.unbindAndClose();
        }
    }

    private static BindParameter binding() {
        return new BindParameter(
                BindType.BIND_TRX,
                "jsmpp",
                "",
                "",
                TypeOfNumber.INTERNATIONAL,
                NumberingPlanIndicator.ISDN,
                APPLICATION);
    }

    private static String taken(BlockingQueue<String> texts) throws InterruptedException {
        String text = texts.poll(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
        assertTrue(text != null, "no text came");
        return text;
    }

    /** @param isStopped likewise */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void kannelDrivesTheRobot(boolean isStopped) throws Exception {
        Peer.BEARERBOX.require();
        Peer.SMSBOX.require();
        BlockingQueue<String> replies = new LinkedBlockingQueue<>();
        HttpServer receiver = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        receiver.createContext("/reply", exchange -> {
            replies.add(URLDecoder.decode(exchange.getRequestURI().getRawQuery(), StandardCharsets.UTF_8));
            exchange.sendResponseHeaders(200, -1);
            exchange.close();
        });
        receiver.start();
        try (Scenario scenario = new Scenario("Kannel drives the robot")) {
            RunningProgram center = scenario.center("--smpp", "0");
            RunningProgram robot = scenario.robot("empty.map", "--speed", "20");
            int statusPort = freePort();
            int sendPort = freePort();
            Path file = Files.writeString(
                    scenario.folder().resolve("kannel.conf"),
                    configuration(
                            scenario,
                            statusPort,
                            sendPort,
                            receiver.getAddress().getPort()));
            if (isStopped) {
                StoppedServerTest.stop(center);
            }
            Process bearerbox = start(scenario, Peer.BEARERBOX, file);
            awaitAnswer(bearerbox, statusPort, "/status.txt?password=test");
            Process smsbox = start(scenario, Peer.SMSBOX, file);
            try {
                awaitAnswer(
                        smsbox,
                        sendPort,
                        "/cgi-bin/sendsms?username=test&password=test&from=" + APPLICATION + "&to=" + Scenario.ROBOT
                                + "&text=" + URLEncoder.encode(ORDER, StandardCharsets.UTF_8));
                String reply = taken(replies);
                assertTrue(reply.startsWith("from=" + Scenario.ROBOT + "&text=" + DONE), reply);
                robot.expect("order", "verdict", "accepted");
            } finally {
                smsbox.destroyForcibly();
                bearerbox.destroyForcibly();
            }
        } finally {
            receiver.stop(0);
        }
    }

    private static String configuration(Scenario scenario, int statusPort, int sendPort, int replyPort)
            throws IOException {
        return """
                group = core
                admin-port = %d
                admin-password = test
                smsbox-port = %d
                box-allow-ip = "127.0.0.1"

                group = smsc
                smsc = smpp
                smsc-id = simgsm
                host = 127.0.0.1
                port = %d
                transceiver-mode = true
                smsc-username = kannel
                smsc-password = kannel
                system-type = ""
                address-range = "%s"

                group = smsbox
                bearerbox-host = 127.0.0.1
                sendsms-port = %d
                sendsms-interface = 127.0.0.1

                group = sendsms-user
                username = test
                password = test

                group = sms-service
                keyword = default
                max-messages = 0
                get-url = "http://127.0.0.1:%d/reply?from=%%p&text=%%a"
                """.formatted(statusPort, freePort(), scenario.smppPort(), APPLICATION, sendPort, replyPort);
    }

    /** A free port below those from 32768 on, one of which the system might give to another program before Kannel opens it. */
    private static int freePort() {
        while (true) {
            int port = nextPort++;
            try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                return socket.getLocalPort();
            } catch (IOException isTaken) {
                continue;
            }
        }
    }

    private static Process start(Scenario scenario, Peer box, Path configuration) throws IOException {
        return box.process(configuration.toString())
                .directory(scenario.folder().toFile())
                .redirectOutput(scenario.folder().resolve(box + ".log").toFile())
                .start();
    }

    /** Sends a request to a box until the box is up and answers; the answer must be one of success. */
    private static void awaitAnswer(Process box, int port, String path) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path))
                .build();
        while (box.isAlive()) {
            try {
                int status = HttpClient.newHttpClient()
                        .send(request, HttpResponse.BodyHandlers.discarding())
                        .statusCode();
                assertEquals(2, status / 100, path);
                return;
            } catch (IOException notUpYet) {
                box.waitFor(100, TimeUnit.MILLISECONDS);
            }
        }
        throw new AssertionError("the box has ended with " + box.exitValue());
    }
}
