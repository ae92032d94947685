package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** What the robots' cameras see and how they are, as a file by command and over the web. */
class CamerasTest {
    private final HttpClient client = HttpClient.newHttpClient();

    private static RunningProgram robots(Scenario scenario, String... more) {
        String[] options = new String[more.length + 5];
        String[] first = {
            "--headless", "--lang=en", "--no-sound", "--world=" + Scenario.world("demo.map"), "--center=127.0.0.1:1"
        };
        System.arraycopy(first, 0, options, 0, first.length);
        System.arraycopy(more, 0, options, first.length, more.length);
        return scenario.start("robots", "simrobot", options);
    }

    private <T> HttpResponse<T> ask(String method, String port, String path, HttpResponse.BodyHandler<T> body)
            throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path))
                .method(method, HttpRequest.BodyPublishers.noBody())
                .build();
        return client.send(request, body);
    }

    private HttpResponse<String> text(String method, String port, String path) throws Exception {
        return ask(method, port, path, HttpResponse.BodyHandlers.ofString(StandardCharsets.UTF_8));
    }

    @Test
    void aCommandWritesThePictureThatTheFilesNameAsksFor() throws Exception {
        try (Scenario scenario = new Scenario("camera pictures as files")) {
            RunningProgram robots = robots(scenario, "--robots=all");
            robots.expect("ready");
            for (String name : new String[] {"view.png", "view.jpg"}) {
                Path file = scenario.folder().resolve(name);
                ConsoleEvent written = robots.say("@Window camera " + file).expect("camera", "robot", "Window");
                assertEquals(file.toString(), written.field("file"));
                assertEquals(320, ImageIO.read(file.toFile()).getWidth());
                assertEquals(240, ImageIO.read(file.toFile()).getHeight());
            }
            robots.say("camera view.txt").expect("error");
            assertEquals(0, robots.quit());
        }
    }

    @Test
    void aBrowserGetsThePageStatusPicturesAndStreams() throws Exception {
        try (Scenario scenario = new Scenario("robots on the web")) {
            RunningProgram robots = robots(scenario, "--robots=all", "--http=0", "--p2os=0");
            String port = robots.expect("ready").field("http");

            HttpResponse<String> page = text("GET", port, "/");
            assertEquals(200, page.statusCode());
            assertTrue(page.body().contains("/robots/Window/camera.jpg"), page.body());

            scenario.tell("status follows what happens");
            robots.say("place -1 0.2 90").expect("pose");
            robots.say("motors off").expect("status", "value", "No motors");
            // an answer may be 50 ms old
            String status = text("GET", port, "/robots/Home").body();
            for (int i = 0; i < 1000 && !status.contains("No motors"); i++) {
                status = text("GET", port, "/robots/Home").body();
            }
            assertTrue(status.contains("\"status\":\"No motors\""), status);
            assertTrue(status.contains("\"x\":-1.0000,\"y\":0.2000,\"heading\":90.00"), status);
            String all = text("GET", port, "/robots").body();
            assertTrue(all.startsWith("[{\"name\":\"Home\"") && all.contains("{\"name\":\"Window\""), all);

            scenario.tell("pictures");
            HttpResponse<byte[]> picture =
                    ask("GET", port, "/robots/Home/camera.jpg", HttpResponse.BodyHandlers.ofByteArray());
            assertEquals(
                    "image/jpeg", picture.headers().firstValue("Content-Type").orElseThrow());
            assertEquals(
                    320, ImageIO.read(new ByteArrayInputStream(picture.body())).getWidth());
            HttpResponse<InputStream> stream =
                    ask("GET", port, "/robots/Home/camera.mjpg", HttpResponse.BodyHandlers.ofInputStream());
            try (InputStream parts = stream.body()) {
                String start = new String(parts.readNBytes(60), StandardCharsets.ISO_8859_1);
                assertTrue(start.startsWith("--simrobot-frame\r\nContent-Type: image/jpeg\r\n"), start);
            }

            scenario.tell("and only that");
            assertEquals(404, text("GET", port, "/robots/nobody").statusCode());
            assertEquals(404, text("GET", port, "/robots/nobody/camera.mjpg").statusCode());
            assertEquals(405, text("POST", port, "/robots/Home").statusCode());
            assertEquals(405, text("DELETE", port, "/").statusCode());
            assertEquals("", text("HEAD", port, "/robots").body());
            assertEquals(0, robots.quit());
        }
    }
}
