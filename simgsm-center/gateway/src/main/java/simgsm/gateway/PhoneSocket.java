package simgsm.gateway;

import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.speech.SpeechCodec;
import simgsm.web.JsonReader;
import simgsm.web.WebSocket;
import simgsm.web.WebSocketListener;

/** The socket {@code /phone} of one page: the key first, then orders as JSON and sound as A-law. */
final class PhoneSocket implements WebSocketListener {
    /** The subprotocol. */
    static final String PROTOCOL = "simgsm.v1";

    static final int MOST_OCTETS = 16 * 1024;

    private final WebSocket socket;
    private final WebUsers users;
    /** Null until the key has arrived. */
    private WebUser user;

    PhoneSocket(WebSocket socket, WebUsers users) {
        this.socket = socket;
        this.users = users;
        users.expectKey(socket, () -> user != null);
    }

    @Override
    public void text(String text) {
        Map<String, Object> message;
        try {
            message = JsonReader.object(text);
        } catch (IllegalArgumentException e) {
            if (user == null) {
                socket.close(CloseCode.POLICY_VIOLATION, "expected the key as JSON");
            } else {
                user.tellError(e.getMessage());
            }
            return;
        }
        if (user == null) {
            user = users.join(socket, string(message, "key"), string(message, "token"), string(message, "name"))
                    .orElse(null);
        } else {
            try {
                perform(message);
            } catch (IllegalArgumentException e) {
                user.tellError(string(message, "do") + ": " + e.getMessage());
            }
        }
    }

    private void perform(Map<String, Object> message) {
        switch (string(message, "do")) {
            case "dial" -> check(user.station().dial(number(message)), "there is a call already");
            case "answer" -> check(user.station().answer(), "no call rings");
            case "hangup" -> check(user.station().hangUp(), "there is no call");
            case "sms" -> user.send(number(message), text(message));
            case "inbox" -> user.tellInbox();
            case "ladder" -> user.showLadder(isOn(message));
            default -> throw new IllegalArgumentException("expected dial, answer, hangup, sms, inbox or ladder");
        }
    }

    private static void check(boolean isDone, String otherwise) {
        if (!isDone) {
            throw new IllegalArgumentException(otherwise);
        }
    }

    private static boolean isOn(Map<String, Object> message) {
        String state = string(message, "state");
        check(state.equals("on") || state.equals("off"), "expected the state on or off");
        return state.equals("on");
    }

    private static Msisdn number(Map<String, Object> message) {
        return Msisdn.parse(string(message, "number"));
    }

    private static String text(Map<String, Object> message) {
        String text = string(message, "text");
        check(!text.isEmpty(), "expected a text");
        return text;
    }

    private static String string(Map<String, Object> message, String name) {
        return Optional.ofNullable(message.get(name)).map(Object::toString).orElse("");
    }

    @Override
    public void binary(byte[] octets) {
        if (user == null || octets.length != SpeechCodec.SAMPLES_PER_FRAME) {
            socket.close(WebSocket.UNSUPPORTED_DATA, "expected 160 octets of A-law after the welcome");
        } else {
            user.hear(octets);
        }
    }

    @Override
    public void closed() {
        if (user != null) {
            users.pageGone(user, socket);
        }
    }
}
