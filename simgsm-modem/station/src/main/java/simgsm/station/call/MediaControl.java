package simgsm.station.call;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.MgcpMessage;
import simgsm.abis.MgcpMessage.Head;
import simgsm.air.ProtocolViolation;
import simgsm.station.context.StationContext;

/** Answers a centre that requests speech as RTP over UDP (MGCP, RFC 3435). */
public final class MediaControl {
    private final StationContext context;
    private int connections;

    public MediaControl(StationContext context) {
        this.context = context;
    }

    /** A message of the centre. */
    public void arrived(byte[] payload) {
        try {
            MgcpMessage command = MgcpMessage.decode(payload);
            answer(command).ifPresent(answer -> context.radio().send(IpaFrame.MGCP, answer.encode()));
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "MGCP message dropped: {0}", e.getMessage());
        }
    }

    /** @return empty if the message is no command */
    private Optional<MgcpMessage> answer(MgcpMessage command) {
        return switch (command.head()) {
            case CREATE_CONNECTION -> {
                connections++;
                yield Optional.of(command.media()
                        .flatMap(context.radio()::openMedia)
                        .map(own -> command.created(String.valueOf(connections), own))
                        .orElseGet(() -> command.answered(Head.NO_RESOURCES)));
            }
            case DELETE_CONNECTION -> {
                context.radio().closeMedia();
                yield Optional.of(command.answered(Head.DELETED));
            }
            default -> Optional.empty();
        };
    }
}
