"""roslibpy reads and drives a robot, as roslib_drive.js does.   python3 roslibpy_drive.py PORT"""

import base64
import queue
import sys
import threading

import roslibpy

ros = roslibpy.Ros(host="127.0.0.1", port=int(sys.argv[1]))
ros.run(timeout=30)


def until(name, message_type, wanted=lambda message: True):
    heard = queue.Queue()
    topic = roslibpy.Topic(ros, name, message_type)
    topic.subscribe(heard.put)
    while True:
        message = heard.get(timeout=30)
        if wanted(message):
            topic.unsubscribe()
            return message


def call(name, service_type, arguments):
    return roslibpy.Service(ros, name, service_type).call(roslibpy.ServiceRequest(arguments), timeout=30)


print("topics", len(ros.get_topics()), ros.get_topic_type("/robot/scan"), flush=True)
print("time", ros.get_time()["secs"] >= 0)
scan = until("/robot/scan", "sensor_msgs/LaserScan")
print("scan", len(scan["ranges"]), None in scan["ranges"])
camera = until("/robot/camera/compressed", "sensor_msgs/msg/CompressedImage")
jpeg = base64.b64decode(camera["data"])
print("camera", camera["format"], jpeg[:2] == b"\xff\xd8", "sec" in camera["header"]["stamp"])
velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/TwistStamped")
velocity.advertise()
repeats = threading.Event()


def drive():
    while not repeats.wait(0.1):
        velocity.publish(roslibpy.Message({"twist": {"linear": {"x": 0.2}}}))


def moves(message):
    return message["twist"]["twist"]["linear"]["x"] > 0.1


threading.Thread(target=drive, daemon=True).start()
driven = until("/robot/odom", "nav_msgs/Odometry", moves)
repeats.set()
stood = until("/robot/odom", "nav_msgs/Odometry", lambda each: each["twist"]["twist"]["linear"]["x"] == 0)
print("odom", stood["pose"]["pose"]["position"]["x"] > driven["pose"]["pose"]["position"]["x"])
reply = call("/robot/order", "simgsm/Order", {"keys": "** #**20 **"})
print("order", reply["tone"], reply["text"])
try:
    call("/nope", "std_srvs/Trigger", {})
except roslibpy.core.ServiceException as refused:
    print("wrong", refused)
repeats.clear()
threading.Thread(target=drive, daemon=True).start()
until("/robot/odom", "nav_msgs/Odometry", moves)
print("driving", flush=True)
threading.Event().wait()
